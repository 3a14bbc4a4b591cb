import {structure} from "../measures.mjs";
import {pyramid} from "../scenes.mjs";

export const run = ({page, ours, shipped, number}) => {
    page.section("Box3D's pyramid of cubes",
        "210 cubes of 1 m and 100 kg that touch, twenty at the bottom; 1000 steps of 1/60 s. It is Box3D's benchmark large_pyramid at the size that it has there in debug builds; of one of 80 at the bottom a comment in its source says \u201cThe 80 block version falls over after 1000 steps.\u201d MuJoCo is run at 1/60 s as well, because its own step would take minutes.",
        "https://github.com/erincatto/box3d/blob/main/shared/benchmarks.c");
    const scene = pyramid(20);
    structure({page, runs: [ours("default"), ...shipped], scene, seconds: 1000 / 60, size: 1, number, rate: 60});
};
