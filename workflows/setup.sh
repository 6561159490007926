#!/usr/bin/env bash
# Installs the Debian 12 packages that octacut needs and that are missing, as root
# or with sudo, and those that arguments name. If neither is possible, it prints
# the missing packages and fails. With `--with_test_tools 1` first, also what only
# tests need, which are skipped without it.
# If all packages are installed, it changes nothing.
set -euo pipefail

# Read what octacut exports; run its pages.
test_tools=(
  admesh prusa-slicer blender
  chromium chromium-driver nodejs
)
if [[ ${1:-} == --with_test_tools ]]; then
  if ((!${2:?"$1 needs 0 or 1"})); then
    test_tools=()
  fi
  shift 2
else
  test_tools=()
fi

packages=(
  g++ cmake make ninja-build
  libeigen3-dev libfmt-dev libspdlog-dev libtbb-dev nlohmann-json3-dev
  libopencv-dev libopenmesh-dev libembree-dev libboost-dev
  libceres-dev
  lib3mf-dev
  libjs-three
  libgtest-dev libgmock-dev
  colmap jq shellcheck imagemagick
  "${test_tools[@]}"
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
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
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
