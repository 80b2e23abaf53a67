#!/usr/bin/env python3
"""Makes sets.csv, names.txt, geometry.csv and performance.csv from files of the UIUC Propeller Database.

usage: make_compact.py INDEX.csv DOWNLOAD_DIR

DOWNLOAD_DIR is laid out as on the site (volume-1/data/apce_10x5_geom.txt and so on). INDEX.csv has one row per
propeller with the columns volume, prop, family, blades, D_in, geom_file, beta_offset_deg, static_file, inflight_files
(separated by ';'). The output goes beside this script: numbers only, no text of the originals.
"""
import csv
import math
import os
import re
import sys

SLOW_FLYER_FAMILIES = ("apcsf", "gwssf")
# Names that leave out the decimal point of the pitch or of the diameter.
PRINTED = {"ancf_125x5": (12.5, 5), "apce_13x65": (13, 6.5), "apce_14x85": (14, 8.5)}


def printed_pitch_ratio(prop):
    """Pitch over diameter as printed on the propeller, or None where the name has no pitch."""
    if prop in PRINTED:
        diameter, pitch = PRINTED[prop]
        return pitch / diameter
    match = re.search(r"_([\d.]+)x([\d.]+)", prop)
    return float(match.group(2)) / float(match.group(1)) if match else None


def rows(path, columns):
    """The rows of numbers of a file; header lines, also repeated ones, are left out."""
    with open(path, encoding="latin-1") as lines:
        for line in lines:
            words = line.split()
            try:
                values = [float(word) for word in words]
            except ValueError:
                continue
            if len(values) >= columns and all(map(math.isfinite, values[:columns])):
                yield values[:columns]


def main():
    index, root = sys.argv[1:3]
    here = os.path.dirname(os.path.abspath(__file__))
    with open(index, encoding="utf-8") as f:
        propellers = list(csv.DictReader(f))
    with open(os.path.join(here, "sets.csv"), "w", encoding="utf-8") as sets, \
            open(os.path.join(here, "names.txt"), "w", encoding="utf-8") as names, \
            open(os.path.join(here, "geometry.csv"), "w", encoding="utf-8") as geometry, \
            open(os.path.join(here, "performance.csv"), "w", encoding="utf-8") as performance:
        print("set,volume,blades,diameter [in],pitch_ratio,slow_flyer", file=sets)
        print("set,r_R,c_R,beta [deg]", file=geometry)
        print("set,run,speed [rpm],J,CT,CP", file=performance)
        for number, p in enumerate(propellers):
            ratio = printed_pitch_ratio(p["prop"])
            slow = int(p["family"] in SLOW_FLYER_FAMILIES)
            static = os.path.splitext(os.path.basename(p["static_file"]))[0]
            print(p["prop"], static, file=names)
            print(number, p["volume"], p["blades"], float(p["D_in"]),
                  f"{ratio:.6g}" if ratio else 0, slow, sep=",", file=sets)
            for x, chord, beta in rows(os.path.join(root, p["geom_file"]), 3):
                print(number, f"{x:g}", f"{chord:g}", f"{beta + float(p['beta_offset_deg']):g}",
                      sep=",", file=geometry)
            for rpm, ct, cp in rows(os.path.join(root, p["static_file"]), 3):
                print(number, 0, f"{rpm:g}", 0, f"{ct:g}", f"{cp:g}", sep=",", file=performance)
            for run, name in enumerate(filter(None, p["inflight_files"].split(";")), start=1):
                rpm = float(re.search(r"_(\d+)\.txt$", name).group(1))
                for j, ct, cp, _ in rows(os.path.join(root, name), 4):
                    print(number, run, f"{rpm:g}", f"{j:g}", f"{ct:g}", f"{cp:g}", sep=",",
                          file=performance)


if __name__ == "__main__":
    main()
