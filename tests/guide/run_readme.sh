#!/usr/bin/env bash
# run_readme.sh README BUILD SOURCE: runs each command under "## Using it" as it is printed, against an
# installation of BUILD, in a folder with the files that the README calls the reader's own.
set -euo pipefail
. "$(dirname "$0")/carry_out.sh"
readme=$(realpath "$1") source=$(realpath "$3")
carry_out /dev/null "$2"
guide=$readme
export PATH=$PREFIX/bin:$PATH

cat >graph.json <<'GRAPH'
{
  "wrinkle": 1,
  "inputs": { "wear": { "type": "float", "default": 0.2 } },
  "presets": { "Old": { "wear": 0.9 } },
  "nodes": {
    "noise": { "type": "gradient_noise", "in": { "scale": 8 } },
    "bump": { "type": "gradient_from_height", "in": { "height": { "from": "noise.height" } } },
    "end": { "type": "resolve", "in": { "gradient": { "from": "bump.gradient" } } }
  },
  "outputs": {
    "normal": { "from": "end.normal" }, "roughness": { "from": "input.wear" },
    "height": { "from": "noise.height" }, "displacement": { "from": "noise.height" }
  }
}
GRAPH
cp graph.json old.json
sed 's/"scale": 8/"scale": 9/' graph.json >new.json
mkdir -p textures graphs/golden
cp "$source"/graphs/textures/rivets_normal.png textures/rivets_normal_gl.png
cp "$source"/graphs/textures/rivets_normal.png reference.png
cp reference.png other.png
cp "$source"/graphs/textures/weave_height.png height.png
cp "$source"/graphs/compare/meshes/bent_cylinder.glb my_mesh.glb
oiiotool --create 64x32 3 --fill:color=1,2,3 64x32 -o my_sky.hdr
echo "0:12(3): error: syntax error" >driver.log
printf 'uv0.x,uv0.y\n0.25,0.5\n' >places.csv
cp "$source"/graphs/rings.json "$source"/graphs/rings.test.json graphs/
cp "$source"/graphs/golden/rings.* graphs/golden/
cp "$build"/lib/wrinkle/plugins/ripples.so my_nodes.so
git init -q .

commands=0
while IFS= read -r line; do
    case $line in
        wrinkle\ watch*) limit=3 wanted=124 ;;  # it ends when it is stopped
        wrinkle\ diff*) limit=300 wanted=1 ;;   # as diff exits for different files
        *) limit=300 wanted=0 ;;
    esac
    result=0
    timeout $limit bash -c "$line" >said 2>&1 || result=$?
    [ $result = $wanted ] || fail "this exits with $result: $line" "$(cat said)"
    commands=$((commands + 1))
done < <(sed -n '/^## Using it/,/^## In a program/s/^    \(wrinkle\|source\) /\1 /p' "$readme")
[ $commands -ge 25 ] || fail "only $commands commands"
echo "$commands commands"
