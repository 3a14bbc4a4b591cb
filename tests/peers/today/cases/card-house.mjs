import {structure} from "../measures.mjs";
import {cardHouse} from "../scenes.mjs";

export const run = ({page, ours, others, number}) => {
    page.section("Solver2D's house of cards",
        "40 cards of 2 mm and 0.4 m in five storeys, friction 0.7; 10 s. The source says of it \u201cFrom PEEL\u201d, the laboratory in which Pierre Terdiman compares engines; as it is published, lying cards overlap their neighbours and the lowest the ground, so it settles by a centimetre or two. The scene has two dimensions there, here cards are 0.4 m wide.",
        "https://github.com/erincatto/solver2d/blob/main/samples/collection/sample_contact.cpp");
    const scene = cardHouse();
    structure({page, runs: [ours("default"), ours("exact", ["--preset", "exact"]), ...others], scene, seconds: 10, size: 0.4, number, settled: 1});
};
