// Ways to look at two pictures: side by side, swapped in place, a slider, or their difference. Without this script they
// are side by side.
(() => {
    const modes = document.querySelector(".modes");
    if (!modes) return;
    const body = document.body;
    const buttons = [...modes.querySelectorAll("button")];
    const whats = [...document.querySelectorAll(".what")];
    let timer = 0;

    // Pixels of small pictures are seen as such.
    for (const picture of document.querySelectorAll(".stage img")) {
        const look = () => picture.classList.toggle("enlarged", picture.naturalWidth < picture.clientWidth);
        picture.addEventListener("load", look);
        if (picture.complete) look();
    }

    const tell = () => {
        const slider = body.dataset.mode === "slider";
        const text = body.classList.contains("second") ? "Now: actual" : "Now: expected";
        for (const what of whats) what.textContent = slider ? "Left: expected. Right: actual." : text;
    };

    const swap = () => {
        body.classList.toggle("second");
        tell();
    };

    // They change by themselves until one is clicked: the eye sees what jumps.
    const blink = (on) => {
        clearInterval(timer);
        timer = on ? setInterval(swap, 700) : 0;
    };

    const choose = (mode) => {
        body.dataset.mode = mode;
        for (const button of buttons) button.setAttribute("aria-pressed", String(button.value === mode));
        blink(mode === "swap" && !matchMedia("(prefers-reduced-motion: reduce)").matches);
        tell();
    };

    for (const button of buttons) button.addEventListener("click", () => choose(button.value));
    for (const stage of document.querySelectorAll(".stage")) {
        stage.addEventListener("click", (event) => {
            if (["swap", "slider"].includes(body.dataset.mode)) event.preventDefault();
            if (body.dataset.mode !== "swap") return;
            blink(false);
            swap();
        });
        const cut = stage.parentElement.querySelector(".cut");
        const move = (share) => stage.style.setProperty("--cut", `${100 * Math.min(Math.max(share, 0), 1)}%`);
        cut.addEventListener("input", () => move(cut.value / 100));
        stage.addEventListener("pointermove", (event) => {
            if (body.dataset.mode !== "slider" || (event.pointerType !== "mouse" && event.buttons === 0)) return;
            const box = stage.getBoundingClientRect();
            move((event.clientX - box.left) / box.width);
            cut.value = (100 * (event.clientX - box.left)) / box.width;
        });
    }
    addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.target.matches("input, button") && event.key === " ") return;
        const button = buttons[Number(event.key) - 1];
        if (button) choose(button.value);
        if (event.key === " " && body.dataset.mode === "swap") {
            event.preventDefault();
            blink(false);
            swap();
        }
    });
    modes.hidden = false;
    const asked = location.hash.slice(1);  // page.html#swap
    choose(buttons.some((button) => button.value === asked) ? asked : "side");
})();
