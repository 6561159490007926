#!/usr/bin/env bash
# Formats all C++ files with clang-format and lints those that have changed with
# clang-tidy, both of Debian 12 (version 14).
#   workflows/format.sh [options]
# --check 1        change nothing; exit with 1 if a file is not formatted
# --since COMMIT   lint what has changed since then; default HEAD, which is what is
#                  not committed yet
# --lint 0         do not lint
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
check=0
since=HEAD
lint=1
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --check) check=${2:?"$1 needs 0 or 1"} ;;
    --since) since=${2:?"$1 needs a commit"} ;;
    --lint) lint=${2:?"$1 needs 0 or 1"} ;;
    *)
      echo "format: $1: no such option; --help lists them" >&2
      exit 1
      ;;
  esac
  shift 2
done
cd "$root"
# That there is no HEAD~1, in a shallow clone for instance, is no mistake.
if [[ ! $since =~ ^HEAD([~^][0-9]*)*$ ]] &&
  ! git rev-parse --quiet --verify "$since^{commit}" >/dev/null; then
  echo "format: --since $since: no such commit" >&2
  exit 1
fi
if [[ $(clang-format --version 2>/dev/null) != *"version 14."* ]]; then
  echo "format: clang-format 14 is needed; run workflows/setup.sh clang-format clang-tidy" >&2
  exit 1
fi

mapfile -t files < <(git ls-files --cached --others --exclude-standard '*.cc' '*.h')
existing=()
for file in "${files[@]}"; do
  [[ ! -f $file ]] || existing+=("$file")
done
if ((check)); then
  clang-format --dry-run --Werror "${existing[@]}"
else
  clang-format -i "${existing[@]}"
fi
((lint)) || exit 0

if ! git rev-parse --quiet --verify "$since^{commit}" >/dev/null; then
  echo "format: $since: no such commit; nothing is linted"
  exit 0
fi
mapfile -t changed < <(
  git diff --name-only --diff-filter=d "$since" -- '*.cc'
  git ls-files --others --exclude-standard '*.cc'
)
if ((${#changed[@]} == 0)); then
  exit 0
fi
# clang-tidy needs the command of every single file (no unity build), and cannot
# read what g++ has precompiled.
build=${OCTACUT_BUILD_DIR:-$root/build}/lint
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DOCTACUT_UNITY_BUILD=OFF -DOCTACUT_PRECOMPILE=OFF >/dev/null
printf '%s\n' "${changed[@]}" |
  xargs -P "$(nproc)" -n 1 \
    clang-tidy -p "$build" --quiet --warnings-as-errors='*'
