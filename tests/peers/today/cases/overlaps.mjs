import {outcome, words} from "../measures.mjs";
import {stack} from "../scenes.mjs";

export const run = ({page, ours, shipped}) => {
    page.section("Stability atlas: overlap and time step",
        `Five cubes of 1 m and 1 kg, each inside what is below it by a share of its edge, in steps of different length; after 3 s. ${words} Each cell opens its replay. Settings as shipped but for the step.`);
    for (const {engine, setting, run} of [ours("default"), ...shipped]) {
        page.grid(engine, setting.split(",")[0], "overlap", [0.01, 0.05, 0.1, 0.2, 0.4, 0.7, 0.9], "steps a second", [15, 30, 60, 120, 240, 480], (overlap, rate) => {
            const scene = stack(5, 1, overlap), trajectory = run(scene, 3, {rate, perSecond: 15});
            return {text: outcome(scene, trajectory), ...page.record(`${engine}, overlap ${overlap}, ${rate} steps a second`, scene, trajectory, {})};
        });
    }
};
