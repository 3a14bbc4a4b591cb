import {deepest} from "../measures.mjs";
import {heap} from "../scenes.mjs";

export const run = ({page, ours, shipped, program, out, number}) => {
    page.section("Box3D's heap of convex bodies",
        "640 equal hulls of 32 random points on a ball of 2 m, in ten layers of 8 x 8, collapse; 4 s. It is the benchmark convex_pile at the size that it has in debug builds (80 layers else): \u201cHuge pile of large convexes, ported from PEEL.\u201d Depths are measured by this program in all of them. MuJoCo is run at 1/60 s, because its own step would take minutes.",
        "https://github.com/erincatto/box3d/blob/main/shared/benchmarks.c");
    const scene = heap(program, 10, out);
    page.table([ours("default"), ...shipped].map(({engine, setting, run}) => {
        const trajectory = run(scene, 4, {perSecond: 10, rate: 60});
        const at = (time) => trajectory.find((state) => state.time > time - 1e-3);
        const shown = page.record(`${engine}, ${setting}`, scene, trajectory, {at: 4});
        return {engine, setting: engine.startsWith("MuJoCo") ? "as shipped, at 1/60 s" : setting,
            ...Object.fromEntries([1, 2, 3, 4].map((time) => [`deepest overlap at ${time} s, m`, deepest(program, scene, at(time), out)])),
            "below the ground": trajectory.at(-1).bodies.filter(({position}) => position[1] < 0).length, shown};
    }), number, [1, 2, 3, 4].map((time) => `deepest overlap at ${time} s, m`));
};
