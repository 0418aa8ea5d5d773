// What the peers' scripts share: the chains of tests/bench/graphs.h, and a line of JSON for each
// length: {"peer", "version", "layers", "ms", "least", "reads",
// "bytes"}; ms is the median of the builds.
import { performance } from "node:perf_hooks";

export const images = 8;
export const layerScale = (i) => i + 2;

const rounds = { 2: 200, 10: 200, 100: 60 };

// `build` makes a graph of so many layers and gives its fragment text.
export async function measure(peer, version, build) {
    for (const layers of Object.keys(rounds).map(Number)) {
        let text = "";
        for (let i = 0; i < rounds[layers] / 2; ++i) text = await build(layers);  // compiled by then
        const times = [];
        for (let i = 0; i < rounds[layers]; ++i) {
            const start = performance.now();
            text = await build(layers);
            times.push(performance.now() - start);
        }
        times.sort((a, b) => a - b);
        const reads = text.match(/\btexture(2D)?\s*\(/g)?.length ?? 0;
        console.log(JSON.stringify({ peer, version, layers, ms: times[times.length >> 1],
                                     least: times[0], reads, bytes: text.length }));
    }
}
