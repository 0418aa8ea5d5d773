"""The six graphs of the proof, below graphs/, and the values of their inputs."""

PLAIN = "base_and_detail"
DETAIL_ON_UV1 = "woven_strap"
TRIPLANAR = "triplanar_rock"
NOISE = "noise_rock"
LAYERED = "materials/chipped_paint"
PARALLAX = "parallax_detail"
ALL = [PLAIN, DETAIL_ON_UV1, TRIPLANAR, NOISE, LAYERED, PARALLAX]

# Of maps of 2048 texels: with values that leave detail which these hold, since between two texels a
# map is not the graph. A map has no parallax.
OF_MAPS = {PLAIN: [], DETAIL_ON_UV1: ["tile.scale=[1, 1]"],
           TRIPLANAR: ["pebbles.tiling=0.2", "weave.tiling=0.4", "slopes.tiling=0.2",
                       "relief.tiling=0.3"],
           NOISE: ["lumps.octaves=2", "cracks.scale=3"], LAYERED: ["input.thickness=0.003"],
           "materials/hammered_gold": []}
