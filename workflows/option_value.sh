#!/usr/bin/env bash
# Prints the value that arguments give to an option, as `NAME value` or
# `NAME=value`, or else the default.
#
#   workflows/option_value.sh NAME DEFAULT [ARGUMENT...]
set -euo pipefail

name=$1
value=$2
shift 2
while [[ $# -gt 0 ]]; do
  if [[ $1 == "$name" && $# -gt 1 ]]; then
    value=$2
    shift
  elif [[ $1 == "$name="* ]]; then
    value=${1#"$name="}
  fi
  shift
done
printf '%s\n' "$value"
