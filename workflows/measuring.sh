# shellcheck shell=bash
# Sourced by the scripts that measure reconstructions. They set `octacut` (the
# executable), `stamp` (a file as old as it was at the start) and `threads`.

# is_among NAME LIST: LIST is empty or names it, comma-separated; "igea" stands
# for igea-exact and igea-mapper.
is_among() {
  local wanted
  [[ -z $2 ]] && return 0
  for wanted in ${2//,/ }; do
    [[ $1 == "$wanted" || $1 == "$wanted"-* ]] && return 0
  done
  return 1
}

# unknown_of LIST NAME...: prints the first of LIST that is_among fits to none.
unknown_of() {
  local wanted name
  for wanted in ${1//,/ }; do
    for name in "${@:2}"; do
      is_among "$name" "$wanted" && continue 2
    done
    echo "$wanted"
    return
  done
}

# fresh REPORT SOURCE...: a whole report, newer than executable and sources.
fresh() {
  local report=$1 source
  jq -e .version "$report" >/dev/null 2>&1 || return 1
  # shellcheck disable=SC2154 # set by who sources this
  for source in "$stamp" "${@:2}"; do
    [[ $report -nt $source ]] || return 1
  done
}

# step FOLDER NAME COMMAND OPTION...: runs octacut, its messages into
# FOLDER/NAME.log and its CPU seconds into FOLDER/NAME.cpu. On failure `error`
# says what went wrong.
step() {
  local folder=$1 name=$2 begin=$SECONDS status=0 TIMEFORMAT=%U
  shift 2
  echo "  $1 ..."
  # shellcheck disable=SC2154
  { time "$octacut" "$@" --num_threads "$threads" --log_color 0 \
    >"$folder/$name.log" 2>&1 || status=$?; } 2>"$folder/$name.cpu"
  ((status == 130)) && exit 130
  if ((status == 0)); then
    echo "  $1: $((SECONDS - begin)) s"
    return 0
  fi
  error=$(sed -n 's/^ERROR: //p' "$folder/$name.log" | tail -n 1)
  [[ -n $error ]] || error=$(tail -n 1 "$folder/$name.log")
  # shellcheck disable=SC2034 # read by who sources this
  error="$1: ${error:-no message} (exit code $status)"
  return 1
}

machine() {
  awk -F ': *' -v threads="$(nproc)" '
    /^model name/ { cpu = $2 }
    /^MemTotal/ { memory = $2 / 1048576 }
    END { printf "%s, %d threads, %.0f GB of memory\n", cpu, threads, memory }
  ' /proc/cpuinfo /proc/meminfo
}
