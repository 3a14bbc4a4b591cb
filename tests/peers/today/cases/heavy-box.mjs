import {structure} from "../measures.mjs";
import {heavyBox} from "../scenes.mjs";

export const run = ({page, ours, others, number}) => {
    page.section("High Mass Ratio 2 of Solver2D: \u201cBig box on small boxes\u201d",
        "A box of 20 m falls by 15 m on two of 1 m, 400 times lighter; 10 s. How far they have moved is of the two small ones. The scene has two dimensions there, here all boxes are 20 m deep.",
        "https://github.com/erincatto/solver2d/blob/main/samples/collection/sample_contact.cpp");
    const scene = heavyBox();
    structure({page, runs: [ours("default"), ...others], scene, seconds: 10, size: 1, number, isMeant: ({name}) => name !== "big"});
};
