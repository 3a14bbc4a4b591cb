import {flight, outcome} from "../measures.mjs";
import {sceneOf} from "../scenes.mjs";

export const run = ({page, ours, others, program, number}) => {
    const scene = sceneOf(program, "intersecting-stack");
    page.section("Figure 7: five cubes that start inside each other",
        "Cubes of 2.4 m, inside each other by 0.4 m and in the ground by 1.2 m. Right is that they part and stand, the topmost at 10.8 m, and keep no speed of their parting. The picture is the state after 0.5 s.");
    const rows = [ours("original method (preset paper)", ["--preset", "paper"]), ours("default"), ...others].map(({engine, setting, run}) => {
        const trajectory = run(scene, 2), shown = page.record(`${engine}, ${setting}`, scene, trajectory, {at: 0.5, camera: {eye_m: [15, 17, 34], target_m: [0, 11, 0]}});
        return {engine, setting, ...flight(scene, trajectory), shown, isRight: outcome(scene, trajectory) !== "explodes"};
    });
    page.table(rows, number, ["greatest stored speed upwards, m/s", "overlap at 0.5 s, m", "overlap at 2 s, m"]);
};
