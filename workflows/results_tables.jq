# docs/results.md from the scenes that make_results.sh has recorded: an array
# of {name, model, state, message, truth, aligned, mesh, hull, comparison}, the
# last three being octacut's reports or null.
# Arguments: $machine (text), $level, $threads.

include "tables";

def phase($name): [.phases[] | select(.name == $name) | .seconds] | add;

def level_rows:
  .[] | select(.mesh) | . as $scene
  | .mesh.reconstruction.levels[]
  | [$scene.name,
     ($scene.mesh.input.views | count),
     "\(.resolution)³",
     (.crust_voxels | count), (.graph_nodes | count), (.cut_voxels | count),
     (.crust_seconds, .visibility_seconds, .consistency_seconds, .cut_seconds,
      .cover_seconds | seconds),
     "\(.grow_rounds) / \(.border_voxels)"]
  | row;

def time_rows:
  .[] | select(.mesh) | .mesh as $mesh | $mesh.reconstruction as $steps
  | ([$steps.levels[] | .crust_seconds, .visibility_seconds,
      .consistency_seconds, .cut_seconds, .cover_seconds] | add) as $levels
  | [$mesh.input.mask_seconds, $mesh.input.region_seconds,
     $mesh.input.image_seconds, $steps.hull.seconds,
     $steps.prepare_seconds, $steps.evidence.seconds, $levels,
     $steps.meshing.seconds, ($steps.refinement.seconds // 0),
     ($steps.recuts.seconds // 0),
     $steps.coloring_seconds,
     ($mesh | phase("picture"))] as $parts
  | [.name, ($parts[] | seconds),
     ([$mesh.seconds - ($parts | add), 0] | max | seconds),
     ($mesh.seconds | seconds), ($mesh.peak_memory_bytes | gigabytes),
     (.hull.seconds | seconds), (.hull.peak_memory_bytes | gigabytes)]
  | row;

# The self-intersections of the mesh ("mesh") or of the hull.
def self_intersections($kind):
  if .comparison == null then null
  elif .truth then .comparison.meshes[if $kind == "mesh" then 0 else 1 end]
  elif $kind == "mesh" then .comparison.reference
  else .comparison.meshes[0] end
  | .self_intersections.triangles;

def audit_rows:
  .[] | . as $scene
  | ("mesh", "hull") as $kind
  | select($scene[$kind]) | $scene[$kind].audit
  | ["\($scene.name), \(if $kind == "mesh" then "octacut" else "hull" end)",
     (.vertices | count), (.triangles | count), (.closed | yes_no),
     (.edge_manifold | yes_no), (.vertex_manifold | yes_no),
     (.oriented and .outward | yes_no), (.components | count),
     (.genus | count), ($scene | self_intersections($kind) | count)]
  | row;

def distances:
  .mean_over_diagonal, .rms_over_diagonal, .percentile_90_over_diagonal,
  .max_over_diagonal | percent(3);

def truth_rows:
  .[] | select(.truth and .comparison) | . as $scene
  | (0, 1) as $which | .comparison.meshes[$which].comparison
  | ["\($scene.name), \(["octacut", "hull"][$which])",
     (if $scene.aligned then "yes" else "no" end),
     (.to_reference | distances), (.from_reference | distances),
     (.scores[] | .f_score | percent(2))]
  | row;

def thresholds:
  [.[] | select(.truth and .comparison)
   | .comparison.meshes[0].comparison.scores[].threshold]
  | unique | map("F \(. * 1000 | round / 10) %");

# The aims that were set for 512^3.
def aims:
  def verdict($holds): if $holds then "met" else "**not met**" end;
  def aim($text; $found; $holds): [$text, $found, verdict($holds)] | row;
  map(select(.mesh or .state == "failed")) as $made
  | ($made | map(select(.mesh.audit | . and .closed and .edge_manifold and
      .vertex_manifold and .oriented and .components == 1))) as $good
  | aim("every mesh closed, 2-manifold, one component";
        "\($good | length) of \($made | length)";
        ($good | length) == ($made | length)),
    ($made[] | select(.name == "igea-exact") |
      (select(.comparison) | .comparison.meshes[0].comparison
       | [.to_reference, .from_reference | .mean_over_diagonal] as $means
       | aim("igea-exact: mean distance at most 0.15 % of the diagonal, both ways";
             ($means | map(percent(3) + " %") | join(", "));
             ($means | max) <= 0.0015)),
      aim("igea-exact: peak memory at most 4 GB";
          (.mesh.peak_memory_bytes | gigabytes) + " GB";
          .mesh.peak_memory_bytes <= 4e9));

def left_out:
  [.[] | select(.state != "done")
   | if .state == "failed" then "- **\(.name) failed**: \(.message)"
     else "- \(.name): \(.message)" end];

pow(2; $level) as $resolution
| "# Results",
  "",
  "Written by `workflows/make_results.sh DATA_FOLDER"
    + (if $level == 9 then "" else " --target_level \($level)" end)
    + (if $threads == 2 then "" else " --num_threads \($threads)" end)
    + "`; do not edit.",
  "",
  "octacut \([.[] | .mesh.version // empty] | unique | join(", ")) at \($resolution)³ voxels with \($threads) threads on: \($machine).",
  "",
  "`-exact`: the cameras that rendered the images (`sparse_gt`); `-mapper`: COLMAP's mapper found them (`sparse/0`). The example is octacut's own (`octacut example_creator`).",
  (left_out | select(length > 0) | "", "Not in the tables, or only in part:", "", .[]),
  (select($level == 9 and any(.[]; .mesh)) | "", "## Aims", "",
   table(["aim", "found", ""]; aims)),
  "",
  "## Levels",
  "",
  "Seconds of each step of a level. Silhouettes: the search for what the cut leaves uncovered of them. Growing: rounds in which the crust was grown because the cut touched its border, and cut voxels that still touch it.",
  "",
  table(["scene", "views", "grid", "crust voxels", "graph nodes", "cut voxels",
         "crust, s", "visibility, s", "consistency, s", "cut, s",
         "silhouettes, s", "growing"];
        level_rows),
  "",
  "## Time and memory",
  "",
  "Seconds. Levels: the sum of the table above. Recuts: the coarse refinement that tells whether the second level has to be cut again around its refined surface, and these cuts. Hull alone: `octacut visual_hull_mesher`.",
  "",
  table(["scene", "masks", "region", "images", "hull", "preparation",
         "evidence", "levels", "meshing", "refinement", "recuts", "colours",
         "picture", "other", "total", "peak memory, GB", "hull alone, s", "hull alone, GB"];
        time_rows),
  "",
  "## Audit",
  "",
  "Self-intersections: triangles that cross another one.",
  "",
  table(["mesh", "vertices", "triangles", "closed", "manifold edges",
         "manifold vertices", "oriented outward", "components", "genus",
         "self-intersections"];
        audit_rows),
  "",
  "## Ground truth",
  "",
  "Distances in % of the diagonal of the ground truth's bounding box: accuracy from the mesh to the truth, completeness from the truth to the mesh. F-scores in %, at thresholds in % of the diagonal. Aligned: moved onto the truth first (ICP with scale, octacut's mesh and the hull each by itself, which is kind to the hull), as the mapper's cameras agree with the exact ones only nearly.",
  "",
  table(["mesh", "aligned",
         "accuracy: mean", "RMS", "90 %", "max",
         "completeness: mean", "RMS", "90 %", "max"] + thresholds;
        truth_rows)
