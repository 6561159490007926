# Numbers and tables of Markdown, for the tables of results.

def missing: "–";

def pad($digits): until(length >= $digits; "0" + .);

# A number with so many decimals.
def fixed($decimals):
  if . == null then missing
  elif . < 0 then "-" + (-. | fixed($decimals))
  elif $decimals == 0 then round | tostring
  else (. * pow(10; $decimals) | round | tostring | pad($decimals + 1))
    | .[:-$decimals] + "." + .[-$decimals:]
  end;

def count:
  def grouped:
    if length <= 3 then . else (.[:-3] | grouped) + " " + .[-3:] end;
  if . == null then missing else tostring | grouped end;

def seconds: fixed(1);
def gigabytes: if . == null then missing else . / 1e9 | fixed(2) end;
def percent($decimals): if . == null then missing else . * 100 | fixed($decimals) end;
def yes_no:
  if . == null then missing elif . then "yes" else "**no**" end;

def row: "| " + join(" | ") + " |";

# table(["name", ...]; rows): the first column to the left, numbers right.
def table($columns; rows):
  ($columns | row),
  ($columns | to_entries | map(if .key == 0 then "---" else "---:" end) | row),
  rows;
