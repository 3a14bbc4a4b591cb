import {depth, outcome} from "../measures.mjs";
import {stack} from "../scenes.mjs";

const ratios = [1, 10, 100, 1e3, 1e4, 1e5, 1e6];

export const run = ({page, ours, others, number}) => {
    page.section("A heavy cube on a light one",
        "Cubes of 1 m that touch, the lower one of 1 kg, the upper one heavier by the ratio; 10 s. A number is how deep they overlap at the end, in m, where they stand.");
    page.table([ours("default"), ...others].map(({engine, setting, run}) => ({engine, setting, ...Object.fromEntries(ratios.map((ratio) => {
        const scene = stack(2, ratio), trajectory = run(scene, 10), end = outcome(scene, trajectory);
        return [`ratio ${ratio}`, end === "stands" || end === "sags" ? depth(scene, trajectory) : end];
    }))})), number, ratios.map((ratio) => `ratio ${ratio}`));
};
