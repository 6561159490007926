# docs/accuracy.md from the runs that benchmark_accuracy.sh has recorded: an
# array of {part, scene, degradation, set, level, state, message, cpu_seconds,
# seconds, audit, truth, comparison, evaluation, truth_evaluation}; what was not
# measured is null.
# Arguments: $machine, $command (texts), $level, $data_level, $threads;
# $own_scenes, $hard_scenes, $degradations, $option_sets (lines "name options").

include "tables";

def is_clean: .degradation == "clean";
def is_default: .set == "default";

def distances($side):
  .comparison[$side]
  | .mean_over_diagonal, .percentile_90_over_diagonal, .max_over_diagonal
  | percent(3);
def f_scores: .comparison.scores[] | .f_score | percent(1);

# What is not as in the truth is bold.
def against($found; $true):
  if $found == null then missing
  elif $true == null or $found == $true then $found | tostring
  else "**\($found)** (\($true))" end;
def genus: against(.audit.genus; .truth.genus);
def parts: against(.audit.components; .truth.components);
def crossings:
  .evaluation.self_intersections.triangles
  | if . == null or . == 0 then count else "**\(count)**" end;

def distance_columns:
  ["to: mean", "90 %", "max", "from: mean", "90 %", "max", "F 0.1 %", "0.2 %",
   "0.5 %"];
def distance_cells:
  if .comparison == null then [range(9) | missing]
  else [distances("to_reference"), distances("from_reference"), f_scores] end;

def shape_columns: ["genus", "parts", "self-int."];
def shape_cells: [genus, parts, crossings];

def image_columns:
  ["overlap %", "missed %", "excess %", "outline px", "95 % px", "NCC",
   "NCC 10 %", "compared %"];
# Of a mesh's evaluation.
def image_cells:
  (.silhouettes
   | [(.intersection_over_union | percent(2)), (.missed | percent(2)),
      (.excess | percent(2)), (.outline_mean | fixed(2)),
      (.outline_percentile_95 | fixed(2))])
  + (.reprojection
     | [(.mean_correlation | fixed(3)), (.percentile_10 | fixed(3)),
        (.compared_fraction | percent(1))]);

def time_columns: ["s", "CPU s"];
def time_cells: [(.seconds | seconds), (.cpu_seconds | seconds)];
# Of refinement, over all that precedes it.
def refinement_share:
  if .refine_seconds == null then null
  else .refine_seconds / (.seconds - .refine_seconds - .late_seconds) end;

# The run of the same scene that this one is held against.
def clean_run($runs):
  . as $run
  | $runs | map(select(.scene == $run.scene and is_clean and is_default
                       and .comparison)) | .[0];
# The mean error, both ways; below in units of that of the clean scene.
def mean_error:
  (.to_reference.mean_over_diagonal + .from_reference.mean_over_diagonal) / 2;
# Worse poses are aligned first, so is what they are held against.
def times($reference):
  (.degradation | startswith("poses")) as $moved
  | if .comparison == null or $reference == null then null
    else (.comparison | mean_error)
      / ($reference | (if $moved then .aligned else null end) // .comparison
         | mean_error)
    end;

def worse_or_not($limit):
  if . == null then missing
  elif . > $limit then "**\(fixed(2))**" else fixed(2) end;

# Rows of sets or degradations of a scene, the clean default first.
def changed_rows($runs; $limit; name):
  group_by(.scene)[]
  | (.[0] | clean_run($runs)) as $reference
  | ($reference | select(. != null)), (sort_by(.order)[])
  | [.scene, (if is_clean and is_default then "–" else name end)]
    + distance_cells
    + [times($reference) | worse_or_not($limit)]
    + shape_cells
    + [(.evaluation.silhouettes.outline_mean | fixed(2)),
       (.evaluation.reprojection.mean_correlation | fixed(3))]
    + time_cells
  | row;
def changed_columns($what):
  ["scene", $what] + distance_columns + ["x clean"] + shape_columns
  + ["outline px", "NCC"] + time_columns;

# The first words of lines.
def first_words: [split("\n")[] | select(. != "") | split(" ")[0]];
# A run's cell in the tables of what changes cost; null where it was not made.
def cost_cell($reference; $limit):
  if . == null then missing
  else times($reference) | worse_or_not($limit) end;

# Of each scene what each degradation costs, times the error of the clean scene.
def degraded_matrix($runs; $names):
  table(["scene"] + $names;
        group_by(.scene) | sort_by(.[0].order)[]
        | . as $of_scene
        | (.[0] | clean_run($runs)) as $reference
        | [.[0].scene]
          + [$names[] as $name
             | $of_scene | map(select(.degradation == $name)) | .[0]
             | cost_cell($reference; 1.5)]
        | row);

# Of each set of options what it costs each scene, likewise.
def ablated_matrix($runs; $names):
  (map(select(.comparison)) | group_by(.scene) | sort_by(.[0].order)) as $scenes
  | table(["set"] + [$scenes[] | .[0].scene];
          . as $all
          | $names[] as $name
          | select(any($all[]; .set == $name))
          | [$name]
            + [$scenes[]
               | (.[0] | clean_run($runs)) as $reference
               | map(select(.set == $name)) | .[0]
               | cost_cell($reference; 1.05)]
          | row);

def names: [.[] | "\(.scene)"
  + (if is_clean then "" else " \(.degradation)" end)
  + (if is_default then "" else " \(.set)" end)] | join(", ");
# A line of the table of aims: those of the runs that miss it.
def aim($text; misses):
  length as $all | [.[] | select(misses)] as $missing
  | select($all > 0)
  | [$text, "\($all - ($missing | length)) of \($all)",
     (if $missing == [] then "–" else $missing | names end)]
  | row;

# Aims for the data sets: mean to and from the truth, %, and F at 0.1 %.
def means:
  {"igea-exact 9": [0.035, 0.04, 0.95],
   "igea-exact-fine 10": [0.03, 0.035, 0.96],
   "igea-mapper-fine 10": [0.04, 0.045, 0.94],
   "rocker-exact 9": [0.08, 0.10, 0.80]};

def aims($runs):
  means as $means
  |
  ($runs | map(select(.set != "hull"))) as $made
  | ($made | map(select(.evaluation))
     | aim("no self-intersecting triangle";
           .evaluation.self_intersections.triangles > 0)),
    ($made | map(select(.truth and is_clean and is_default))
     | aim("genus and components of the truth (clean scenes)";
           .audit.genus != .truth.genus
           or .audit.components != .truth.components)),
    ($made
     | map(select(.comparison and (.degradation
         | IN("eroded-2", "dilated-2", "poses-0.5"))))
     | aim("masks off by 2 pixels, poses by 0.5: error at most 1.5 x";
           (. | times(clean_run($runs))) as $times
           | $times != null and $times > 1.5)),
    ($made | map(select(.two_views and is_clean and is_default))
     | aim("cup-2: 98 % of what two views see within 0.5 %";
           .two_views.scores[2].recall < 0.98)),
    ($made | map(select(is_clean and is_default and .level >= 9))
     | aim("refinement at 512³ and more: at most 2 x what precedes it";
           refinement_share > 2)),
    ($made[] | select(.comparison and is_default)
     | select("\(.scene) \(.level)" | in($means))
     | $means["\(.scene) \(.level)"] as [$to, $from, $f]
     | . as $run
     | [$run] | aim("\($run.scene), \(pow(2; $run.level))³: \($to) / \($from) %, F \($f)";
           (.comparison
            | .to_reference.mean_over_diagonal * 100 > $to
              or .from_reference.mean_over_diagonal * 100 > $from
              or .scores[0].f_score < $f)));

def bullets: split("\n")[] | select(. != "")
  | capture("^(?<name>\\S+)\\s*(?<options>.*)$")
  | "- \(.name)" + (if .options == "" then "" else ": `\(.options)`" end);

# Rows of the hard scenes: hull, without and with refinement side by side.
def hard_columns:
  ["scene", "mesh", "judged %", "to: mean", "from: mean", "F 0.1 %", "genus",
   "parts", "overlap %", "NCC", "CPU s"];
def hard_name:
  {"hull-default": "hull", "no-refinement": "`refine 0`"}[.set] // .set;
# Of a comparison, or of none.
def hard_distances:
  [(.judged_share | percent(1)),
   (.to_reference.mean_over_diagonal | percent(3)),
   (.from_reference.mean_over_diagonal | percent(3)),
   (.scores[0]?.f_score | percent(1))];
def hard_rows:
  .[]
  | ([.scene, hard_name] + (.comparison | hard_distances)
     + [genus, parts,
        (.evaluation.silhouettes.intersection_over_union | percent(2)),
        (.evaluation.reprojection.mean_correlation | fixed(3)),
        (.cpu_seconds | seconds)]
     | row),
    (select(.wide_folds)
     | [.scene + ", wide", hard_name] + (.wide_folds | hard_distances)
       + [range(5) | ""]
     | row);
def hard_section:
  "## Hard scenes",
  "",
  "Surfaces on which photographs decide little, and folds. The visual hull alone (`visual_hull_mesher` without options), the mesh before refinement (`--OctahedralMeshing.refine 0`) and that of the defaults. Judged: the share of the truth's area that enough cameras see to be compared. Drapery has folds 4 to 20 pixels wide and 1, 2 or 4 times as deep, whose walls three cameras hardly see: there, two cameras within 80 degrees suffice (`--min_views 2 --max_view_angle 80`); wide: the part where folds are wider than 8 pixels. The scenes metal-rocker to plaster-cheburashka are photographs that `octacut example_creator` makes of the true meshes of data sets, in another material. Of the data sets, cheburashka is a polished bronze and homer glazed porcelain, both rendered; bird (dark, on white paper) and ethiopian (a polished metal head) are photographs.",
  "",
  table(hard_columns; hard_rows),
  "",
  (if any(.[]; is_default) then "![Hard scenes](accuracy_hard.jpg)", ""
   else empty end),
  "Options of `octacut example_creator` for octacut's own scenes, besides `--width 640 --height 480 --num_views 36`:",
  "",
  ($hard_scenes | bullets);

map(select(.part == "hard")) as $hard
| map(select(.part != "hard"))
| to_entries | map(.value + {order: .key}) | . as $runs
| map(select(.evaluation)) as $done
| ($done | map(select(is_clean and is_default))) as $default
| ($done | map(select(is_clean | not))) as $degraded
| ($done | map(select(is_clean and (is_default | not)))) as $ablated
| ($runs + $hard) as $all
| ($all | map(select(.state == "failed"))) as $failed
| ($all | map(select(.state == "left_out"))) as $left_out
| (if ($done | length) == 0 then "# Accuracy on hard scenes" else "# Accuracy" end),
  "",
  "Written by `\($command)`; do not edit. octacut \([$all[] | .version // empty] | unique | join(", ")) with \($threads) threads on: \($machine). Its own scenes at \(pow(2; $level))³ voxels, data sets at \(pow(2; $data_level))³; rods-2 and fingers-2, whose parts are two voxels of 128³ thick, begin with hull_level 8 and are made at \(pow(2; [$level, 8] | max))³.",
  "",
  "Distances in % of the diagonal of the ground truth's bounding box, from the mesh to the truth (accuracy) and from it to the mesh (completeness), over the part of the truth that at least three cameras see at 75 degrees to its normal or less. F-scores in %, at thresholds in % of the diagonal. Genus and components that differ from the truth's (in brackets) are bold. Self-int.: triangles that cross another one.",
  "",
  "Silhouettes: overlap is intersection over union, missed is the object pixels that the mesh does not cover, those at borders included, excess the background pixels that it covers, both in % of the object pixels; outline is the distance between both outlines, pixels. NCC: zero-mean normalised correlation of each view with four neighbours, reprojected by way of the mesh, in windows of 7 x 7; mean, 10th percentile, and how much of the mesh could be compared."
    + (if $default == [] then ""
       else " The scores of the truth itself show how reliable masks and images are." end),
  "",
  (if $degraded == [] then empty
   else "Degraded scenes are evaluated with the clean masks, cameras and images. Meshes from perturbed poses and from the mapper's are first aligned with the truth (except for silhouettes and NCC); the former are compared with the clean mesh, aligned likewise.", "" end),
  (if $default == [] then "CPU s: CPU time of the reconstruction."
   else "s: wall time of the reconstruction, while other programs may have run; CPU s: its CPU time; refinement: the time of refinement divided by that of all earlier steps." end),
  ($failed | select(length > 0) | "",
   (.[] | "- **\([.] | names) failed**: \(.message)")),
  ($left_out | select(length > 0) | "",
   "\($all | length - ($left_out | length)) of \($all | length) runs are shown; the others were not asked for"
     + (map(.scene) | unique | map(select(. as $name
          | all($default[], ($hard[] | select(.evaluation)); .scene != $name)))
        | if . == [] then "" else ", among them all of \(join(", "))" end) + "."),
  (if $default == [] then empty else
  "",
  "## Aims",
  "",
  table(["aim", "met", "missed by"]; $done | aims($done)),
  "",
  "## Scenes",
  "",
  table(["scene"] + distance_columns + shape_columns + time_columns
          + ["refinement"];
        $default[]
        | [.scene] + distance_cells + shape_cells + time_cells
          + [refinement_share | fixed(2)]
        | row),
  ($default[] | select(.two_views) | .two_views
   | "",
     "What two cameras see of cup-2: \(.to_reference.mean_over_diagonal | percent(3)) / \(.from_reference.mean_over_diagonal | percent(3)) % in the mean; \(.scores[2].recall | percent(1)) % of it within 0.5 %."),
  "",
  table(["scene"] + image_columns;
        $default[]
        | ([.scene] + (.evaluation | image_cells) | row),
          (select(.truth_evaluation)
           | ["\(.scene), truth"] + (.truth_evaluation | image_cells) | row)),
  "",
  "Photograph, mesh and mesh with its colours:",
  "",
  (if any($default[]; .truth and .level == $level)
   then "![octacut's own scenes](accuracy_own.jpg)", "" else empty end),
  (if any($default[]; .scene | test("^(igea|rocker|temple|dino|bunny)"))
   then "![Data sets](accuracy_data.jpg)", "" else empty end),
  "Options of `octacut example_creator` for octacut's own scenes, besides `--width 640 --height 480 --num_views 36`:",
  "",
  ($own_scenes | bullets) end),
  ($hard | map(select(.evaluation)) | select(length > 0) | "", hard_section),
  ($degraded | select(length > 0) | "",
   "## Degraded scenes", "",
   "The mean of accuracy and completeness over that of the clean scene, \"x clean\" below:", "",
   ($degraded | degraded_matrix($runs; $degradations | first_words)),
   "",
   table(changed_columns("degraded"); changed_rows($runs; 1.5; .degradation)),
   "", ($degradations | bullets)),
  ($ablated | select(length > 0) | "",
   "## One option changed", "",
   "The mean of accuracy and completeness over that of the defaults:", "",
   ($ablated | ablated_matrix($runs; $option_sets | first_words)),
   "",
   table(changed_columns("set"); changed_rows($runs; 1.05; .set)),
   "", ($option_sets | bullets))
