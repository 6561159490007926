#!/usr/bin/env bash
# Installs the Debian 12 packages that octacut needs and that are missing, as root
# or with sudo, and those that arguments name; before these, --with_test_tools 1
# adds the tools that only tests use, which are skipped without them. If neither
# is possible, it prints the missing packages and fails.
# If all packages are installed, it changes nothing.
set -euo pipefail

# What other programs make of octacut's files and pages: only tests use these.
test_tools=(
  admesh prusa-slicer blender
  chromium chromium-driver nodejs npm
)
npm_test_tools=(gltf-validator@2.0.0-dev.3.10)
with_test_tools=0
if [[ ${1:-} == --with_test_tools ]]; then
  with_test_tools=${2:?--with_test_tools needs 0 or 1}
  shift 2
fi
if [[ $with_test_tools == 1 ]]; then
  # Node.js may have been installed otherwise.
  for tool in "${test_tools[@]}"; do
    [[ $tool == nodejs || $tool == npm ]] && command -v npm >/dev/null && continue
    set -- "$tool" "$@"
  done
fi

packages=(
  g++ cmake make ninja-build
  libeigen3-dev libfmt-dev libspdlog-dev libtbb-dev nlohmann-json3-dev
  libopencv-dev libopenmesh-dev libembree-dev libboost-dev
  libceres-dev
  lib3mf-dev
  libmatio-dev libnanoflann-dev libtinyxml2-dev
  libjs-three
  libgtest-dev libgmock-dev
  colmap jq shellcheck imagemagick
  "$@"
)

is_installed() {
  [[ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is not a Debian system; octacut needs the contents of these packages:" >&2
  echo "  ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done

install_npm_tools() {
  [[ $with_test_tools == 1 ]] || return 0
  local tool
  for tool in "${npm_test_tools[@]}"; do
    npm ls -g "${tool%@*}" >/dev/null 2>&1 ||
      "${as_root[@]}" npm install -g --silent "$tool" >/dev/null
  done
}

as_root=()
if [[ $EUID -ne 0 ]] && sudo -n true 2>/dev/null; then
  as_root=(sudo)
fi
if [[ ${#missing[@]} -eq 0 ]]; then
  install_npm_tools
  exit 0
fi

if [[ $EUID -ne 0 ]]; then
  # -n: never wait for a password that nobody is there to type.
  if command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
    as_root=(sudo)
  else
    echo "setup: these packages are missing and only root can install them:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
fi

echo "setup: installing ${missing[*]}"
echo "setup: a bare system needs 0.4 GB of downloads, 1.6 GB on disk and some minutes"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
install_npm_tools
