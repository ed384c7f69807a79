#!/bin/sh
# scipy_test.sh DATA: what SciPy says. The figures of compare are those of the rotation part of evo's absolute and relative pose
# error, by evo's formulas, for real attitudes against copies with noise, at another rate and with constant turns, as they are and
# aligned; two of the examples with vectors have its numbers, and the lines of Python in the README run. Catches an angle of the wrong
# product, a deviation divided by n - 1, an alignment of the wrong side that is not the best, the inverse, columns that are taken for
# each other. 77, which is skipped, where there is no SciPy.
set -eu
data=$1
for python in python3 /usr/bin/python3 ""; do
    [ -n "$python" ] || {
        echo "SciPy is not installed"
        exit 77
    }
    ! "$python" -c 'import scipy.spatial' 2> /dev/null || break
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/evo.py" << 'END'
import json, os, subprocess, sys
import numpy as np
from scipy.spatial.transform import Rotation


# evo's formulas: the angle of R_ref^-1 R_est, and of (Q_i^-1 Q_j)^-1 (P_i^-1 P_j) with j = i + delta.
def ape(ref, est):
    return (ref.inv() * est).magnitude()


def rpe(ref, est, delta):
    i, j = np.arange(len(ref) - delta), np.arange(delta, len(ref))
    return ((ref[i].inv() * ref[j]).inv() * (est[i].inv() * est[j])).magnitude()


def best_both(ref, est):  # L est S = ref: from the turns between rows, then one side after the other
    i, j = np.arange(len(ref) - 5), np.arange(5, len(ref))
    right = Rotation.align_vectors((est[i].inv() * est[j]).as_rotvec(), (ref[i].inv() * ref[j]).as_rotvec())[0]
    for _ in range(50):
        left = (ref * (est * right).inv()).mean()
        right = ((left * est).inv() * ref).mean()
    return left * est * right


def best_yaw(ref, est):  # the angle about z that makes the sum of (w cos + z sin)^2 greatest
    x, y, z, w = (ref * est.inv()).as_quat().T
    return Rotation.from_euler("z", np.arctan2(2 * np.sum(w * z), np.sum(w * w - z * z))) * est


aligned = {
    "reference": lambda ref, est: (ref * est.inv()).mean() * est,
    "body": lambda ref, est: est * (est.inv() * ref).mean(),
    "both": best_both,
    "yaw": best_yaw,
    "first": lambda ref, est: ref[0] * est[0].inv() * est,
}


def check(what, angles, options):
    run = subprocess.run(["rotconv", "compare", "--format", "json", "--within", "9rad@10", "--within", "9rad@99", "--diagnostics", "off"]
                         + options, capture_output=True, text=True)
    if run.returncode != 0:
        return print(f"FAILED: {what}: exit {run.returncode}: {run.stderr}") or 1
    found = json.loads(run.stdout)
    expected = {"rows": len(angles), "max": max(angles), "rms": np.sqrt(np.mean(angles**2)), "mean": np.mean(angles),
                "std": np.std(angles)}
    for limit in found["limits"]:
        found[f"p{limit['percent']}"] = limit["percentile"]
    for percent, name in ((10, "p10"), (50, "median"), (95, "p95"), (99, "p99")):
        expected[name] = np.percentile(angles, percent, method="inverted_cdf")
    wrong = 0
    for name, value in expected.items():
        if not abs(found[name] - value) <= (1e-3 if name[0] in "pm" and name not in ("max", "mean") else 1e-9) * value + 1e-15:
            wrong += 1
            print(f"FAILED: {what}: {name} is {found[name]}, not {value}")
    return wrong


def polar(matrices):  # SciPy takes matrices for exact
    u, _, v = np.linalg.svd(matrices)
    return Rotation.from_matrix(u @ v)


data, work = sys.argv[1:]
tum = np.loadtxt(f"{data}/tum_fr1_xyz.txt", dtype=str)
euroc = np.loadtxt(f"{data}/euroc.csv", dtype=str, delimiter=",")
kitti = np.loadtxt(f"{data}/kitti.txt").reshape(-1, 3, 4)[:, :, :3]
samples = {  # attitudes, keys, the options that read them
    "tum": (Rotation.from_quat(tum[:, 4:8].astype(float)), tum[:, 0], ["quat:tum", "5-8", f"{data}/tum_fr1_xyz.txt"]),
    "euroc": (Rotation.from_quat(euroc[:, [5, 6, 7, 4]].astype(float)), euroc[:, 0], ["quat", "5-8", f"{data}/euroc.csv"]),
    "kitti": (polar(kitti), None, ["dcm", "1-3,5-7,9-11", f"{data}/kitti.txt"]),
}
everything = Rotation.concatenate([ref for ref, _, _ in samples.values()] * 120)
np.savetxt(f"{work}/all.txt", everything.as_quat(), fmt="%.17g")
samples["all"] = (everything, None, ["quat:xyzw", "1-4", f"{work}/all.txt"])

chance = np.random.default_rng(1)
cases = failures = 0
for name, (ref, keys, (spec, columns, file)) in samples.items():
    left, right = Rotation.from_rotvec([0.3, -0.2, 1.5]), Rotation.from_rotvec([-0.7, 0.4, 0.1])
    noisy = ref * Rotation.from_rotvec(chance.normal(0, 0.01, (len(ref), 3)))
    copies = {"noise": noisy, "left turn": left * noisy, "right turn": noisy * right, "both turns": left * noisy * right}
    if keys is not None:
        copies["rate"] = noisy[1::3]
    for copy, est in copies.items():
        pairs, options = ref, []
        rows = np.char.mod("%.17g", est.as_quat())
        if copy == "rate":
            pairs = ref[1::3]
            later = keys[1::3].astype(np.int64) + 2000000 if name == "euroc" else np.char.mod("%.4f", keys[1::3].astype(float) + 0.002)
            rows = np.column_stack([later.astype(str), rows])
            options = ["--key", "1", "--key-within", "2000000" if name == "euroc" else "0.002", "--allow-unpaired", "reference"]
        np.savetxt(f"{work}/est.txt", rows, fmt="%s")
        options += ["-f", "quat:xyzw", "--columns", "2-5" if copy == "rate" else "1-4", "-t", spec, "--reference-columns", columns,
                    f"{work}/est.txt", file]
        failures += check(f"{name}, {copy}: ape", ape(pairs, est), options)
        for delta in (1, 10):
            if delta < len(pairs):
                failures += check(f"{name}, {copy}: rpe {delta}", rpe(pairs, est, delta), ["--delta", str(delta)] + options)
                cases += 1
        cases += 1
        for side, align in aligned.items():
            if side != "both" or name == "all":  # the samples alone turn too little to determine it to nine digits
                turned = align(pairs, est)
                failures += check(f"{name}, {copy}: --align {side}", ape(pairs, turned), ["--align", side] + options)
                cases += 1
                if side in ("body", "both"):  # the others leave the turns as they are
                    failures += check(f"{name}, {copy}: --align {side}, rpe 1", rpe(pairs, turned, 1),
                                      ["--align", side, "--delta", "1"] + options)
                    cases += 1
print(f"{cases} cases, {failures} figures differ")
sys.exit(failures > 0)
END
"$python" "$work/evo.py" "$data" "$work"

cd "$data"
bias=$(rotconv rotate -f quat --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z,b_a_RS_S_x,b_a_RS_S_y,b_a_RS_S_z euroc.csv |
    sed '/^#/d' | tr -d '\r' | awk -F , 'NF > 9 { print $5, $6, $7; next } { exit 1 }' | tr '\n' ';')
sight=$(grep -v '^#' tum_fr1_xyz.txt | sed 's/$/ 0 0 1/' |
    rotconv rotate -f quat:tum --columns 5-11 --diagnostics off | cut -d ' ' -f 5-7 | tr '\n' ';')
BIAS=$bias SIGHT=$sight "$python" - <<'END'
import os
import numpy as np
from scipy.spatial.transform import Rotation

def rows_of(name):
    return np.array([[float(x) for x in row.split()] for row in os.environ[name].strip(";").split(";")])

euroc = np.loadtxt("euroc.csv", delimiter=",")
tum = np.loadtxt("tum_fr1_xyz.txt")
bias = Rotation.from_quat(np.roll(euroc[:, 4:8], -1, axis=1)).apply(euroc[:, 14:17])
sight = Rotation.from_quat(tum[:, 4:8]).apply([0, 0, 1])
assert rows_of("BIAS").shape == bias.shape and rows_of("SIGHT").shape == sight.shape
worst = max(np.abs(rows_of("BIAS") - bias).max(), np.abs(rows_of("SIGHT") - sight).max())
assert worst < 1e-15, worst
END
{
    sed -n '/^```python$/,/^```$/{/^```/!p;}' ../../README.md
    echo 'turn = np.degrees(2 * np.arctan2(0.6, 0.8))'
    echo 'assert np.allclose(angles, [[0, 0, turn], [0, turn, 0]], rtol=0, atol=1e-12), angles'
} | "$python" -
