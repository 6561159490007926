# docs/experiments/cut_engine_tables.md from the runs of octacut_cut_bench, an array of its JSON
# objects. Arguments: $machine (text).

include "tables";

def ratio($a; $b): if $a == null or $b == null then null else $a / $b end;
# Stored instances: folder and file.
def name: .instance | split("/") | .[-2:] | join("/") | rtrimstr(".oct");

# Of an array of runs the one with the median of their seconds.
def typical:
  if . == null then null
  else sort_by(.cpu_seconds) | .[(length - 1) / 2 | floor] end;

def by_instance:
  reduce .[] as $run ([];
    ($run | name) as $name
    | if any(.[]; .name == $name) then . else . + [{name: $name}] end
    | map(if .name == $name then
        .[if ($run.num_threads // 1) > 1 then "threads" else $run.solver end]
          += [$run]
      else . end))
  | map(. + {single: .octacut, octacut: .octacut | typical,
             boost: .boost | typical, opencv: .opencv | typical,
             tasks: .tasks | typical, lean: .["octacut lean"] | typical});

def cpu: if . == null then null else .cpu_seconds_per_mvoxel end;

def main_rows:
  .[] | select(.octacut)
  | [.name,
     (.octacut.voxels / 1e6 | fixed(2)),
     (.octacut.nodes / .octacut.voxels | fixed(2)),
     (.octacut | cpu | fixed(2)), (.boost | cpu | fixed(2)),
     (.opencv | cpu | fixed(2)),
     (ratio(.octacut | cpu; .boost | cpu) | fixed(2)),
     (.octacut.bytes_per_voxel | fixed(1)),
     (.boost.bytes_per_voxel | fixed(0)),
     (.opencv.bytes_per_voxel | fixed(0)),
     (if .boost == null then missing
      elif .boost.flow == .octacut.flow and .boost.labels_hash == .octacut.labels_hash
      then "yes" else "**no**" end)]
  | row;

def lean_rows:
  .[] | select(.lean and .octacut)
  | [.name, (.lean | cpu | fixed(2)), (.lean.bytes_per_voxel | fixed(1)),
     (100 * (.lean.cost / .octacut.cost - 1) | fixed(4))]
  | row;

def task_rows:
  .[] | select(.tasks) | .tasks as $tasks
  | [.name, (100 * $tasks.search_seconds / $tasks.cpu_seconds | fixed(0)),
     ("2", "8", "16" | $tasks.search_gain[.] | fixed(1)),
     ("2", "8", "16" | $tasks.gain_if_rest_scales[.] | fixed(1))]
  | row;

def thread_rows:
  .[] | select(.threads and .octacut)
  | ([.single[].wall_seconds] | min) as $one
  | ([.threads[].wall_seconds] | min) as $two
  | [.name, ($one | fixed(2)), ($two | fixed(2)), ($one / $two | fixed(2))]
  | row;

def growing_rows:
  .[]
  | [name, (.voxels / 1e6 | fixed(2)), .added_voxels,
     (.cold_cpu_seconds | fixed(2)), (.warm_cpu_seconds | fixed(2)),
     (.warm_cpu_seconds / .cold_cpu_seconds | fixed(2)),
     (if .equal then "yes" else "**no**" end)]
  | map(tostring) | row;

map(select(.solver == "growing")) as $growing
| map(select(.solver != "growing"))
| by_instance
| "# Cut engine: measured",
  "",
  "Written by `workflows/benchmark_cut.sh`; docs/experiments/cut_engine.md says what it means.",
  "",
  $machine + ".",
  "",
  "CPU seconds per million voxels on one thread, building included, the median of",
  "five runs up to 128^3; bytes of a process' growth at its peak and of the grid's",
  "index, a voxel; each run in a process of its own. Boost:",
  "`boykov_kolmogorov_max_flow` on a compressed sparse row graph of 20 bytes an",
  "arc. OpenCV: `detail::GCGraph<double>`. The last column: the same flow and the",
  "same labels as Boost.",
  "",
  table(["instance", "Mvoxels", "nodes a voxel", "octacut s/M", "Boost s/M",
         "OpenCV s/M", "octacut / Boost", "octacut B", "Boost B", "OpenCV B",
         "equal"]; main_rows),
  (if any(.[]; .lean) then
     "",
     "The lean mode; what its cut costs more than the exact one, under the exact",
     "weights:",
     "",
     table(["instance", "s/M", "bytes a voxel", "loss %"]; lean_rows)
   else empty end),
  (if $growing | length > 0 then
     "",
     "Crusts of a reconstruction that grew where their cut touched the border: CPU",
     "seconds of the cut from nothing and from the state of the cut before.",
     "",
     table(["instance", "Mvoxels", "added voxels", "from nothing s",
            "going on s", "ratio", "same labels"]; $growing | growing_rows)
   else empty end),
  "",
  "What more cores would gain, from the CPU seconds of every task on one thread:",
  "the search alone (its share of the whole in percent), and the whole if what",
  "is not the search scales with the cores.",
  "",
  table(["instance", "search %", "search on 2", "8", "16", "all on 2", "8",
         "16"]; task_rows),
  (if any(.[]; .threads) then
     "",
     "Wall seconds, the best of three runs each:",
     "",
     table(["instance", "1 thread", "2 threads", "gain"]; thread_rows)
   else empty end)
