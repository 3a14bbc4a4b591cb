import {structure} from "../measures.mjs";
import {pyramid} from "../scenes.mjs";

export const run = ({page, ours, shipped, number}) => {
    page.section("Box3D's pyramid of 80",
        "The one that falls over in Box3D after 1000 steps, says its author: 3240 cubes of 1 m and 100 kg that touch; 1000 steps of 1/60 s. Without MuJoCo, which would take hours.",
        "https://github.com/erincatto/box3d/blob/main/shared/benchmarks.c");
    const scene = pyramid(80);
    structure({page, runs: [ours("default"), ...shipped.filter(({engine}) => !engine.startsWith("MuJoCo"))], scene, seconds: 1000 / 60, size: 1, number, perSecond: 1});
};
