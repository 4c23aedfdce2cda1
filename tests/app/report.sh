#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# The report has the contract's fields, and no nonsense in them.   report.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
need python3
unset DISPLAY WAYLAND_DISPLAY

"$binary" render --out frame.png --report report.json --size 96x54 --quality low --frames 4 \
  --warmup 2 --fps 10 > stdout.log 2> stderr.log || fail "render: exit code $?"
python3 - report.json << 'CHECK'
import json, math, sys


def refuse(constant):
    raise ValueError(f"{constant} is no JSON")


report = json.load(open(sys.argv[1], encoding="utf-8"), parse_constant=refuse)
kinds = {"renderer": str, "software": bool, "timer": str, "quality": str, "frames": int,
         "frame": dict, "passes": list, "nonfinite_pixels": int, "boat": dict, "sea": dict}
for name, kind in kinds.items():
    assert isinstance(report[name], kind), f"{name} is {report.get(name)!r}"
assert "96" in str(report["size"]) and "54" in str(report["size"]), report["size"]
assert report["quality"] == "low" and report["frames"] == 4
assert report["timer"] in ("gpu", "finish")
if report["software"]:
    assert report["timer"] == "finish", "timer queries are wrong on a software renderer"
assert report["nonfinite_pixels"] == 0
assert report["gl_messages"] in (0, []), report["gl_messages"]

for clock in ("gpu_ms", "cpu_ms"):
    times = report["frame"][clock]
    row = [times[key] for key in ("min", "median", "p95", "p99", "max")]
    assert row == sorted(row) and row[0] > 0, f"frame.{clock} = {times}"

names = [entry["name"] for entry in report["passes"]]
assert len(set(names)) == len(names) > 0, names
for entry in report["passes"]:
    counts = [entry[key] for key in ("ran", "cached", "culled", "skipped")]
    assert all(isinstance(count, int) and count >= 0 for count in counts), entry
    assert sum(counts) == 4, f"{entry['name']} is not accounted for in every frame: {entry}"
    assert counts[0] == 0 or entry["gpu_ms"], entry
assert sum(entry["ran"] > 0 for entry in report["passes"]) >= 3, "hardly anything was drawn"

sea = report["sea"]
assert all(math.isfinite(sea[key]) and sea[key] > 0 for key in ("hs_m", "tp_s")), sea
assert report["boat"], "nothing about the boat"
print("ok:", len(names), "passes:", ", ".join(names))
CHECK
