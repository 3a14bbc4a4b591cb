import {structure} from "../measures.mjs";
import {heavyTops} from "../scenes.mjs";

export const run = ({page, ours, shipped, number}) => {
    page.section("High Mass Ratio 1 of Solver2D and Box3D: pyramids with heavy tops",
        "Three pyramids of 55 cubes of 2 m; the topmost cubes are 100, 200 and 300 times as heavy and fall on the rest from 2 m; 10 s. How far they have moved is of the lighter cubes. Box3D's manual says of its limits \u201cExtreme mass ratios between connected bodies can cause joint stretching and contact overlap.\u201d",
        "https://github.com/erincatto/box3d/blob/main/samples/sample_robustness.cpp");
    const scene = heavyTops();
    structure({page, runs: [ours("default"), ...shipped], scene, seconds: 10, size: 2, number, isMeant: ({name}) => !name.startsWith("top")});
};
