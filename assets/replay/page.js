// Small things of a page.
const $ = (id) => document.getElementById(id);
const say = (text) => { $("said").textContent = text; };
const fail = (text) => {
    $("problem").textContent = text;
    $("problem").hidden = false;
};

const copy = async (text, button, label) => {
    let copied = true;
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        // For browsers that deny the clipboard to pages on disk.
        const area = document.createElement("textarea");
        area.value = text;
        area.style.position = "fixed";
        document.body.append(area);
        area.select();
        copied = document.execCommand("copy");
        area.remove();
        button.focus();
    }
    button.textContent = copied ? "Copied" : "Not allowed";
    say(copied ? "Copied." : "The browser does not allow copying.");
    setTimeout(() => { button.textContent = label; }, 2000);
};

// Both canvases of the view as large as it is.
const fitCanvases = () => {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(16, Math.round($("view").clientWidth * ratio)), height = Math.max(16, Math.round($("view").clientHeight * ratio));
    for (const canvas of [$("picture"), $("marks")]) {
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    }
};

// A text in the corner of each cell.
const showLabels = (cells, texts) => {
    const ratio = $("picture").width / Math.max($("view").clientWidth, 1);
    const key = JSON.stringify([texts, cells, ratio]);
    if ($("labels").dataset.key === key) return;
    $("labels").dataset.key = key;
    $("labels").replaceChildren(...cells.map((cell, i) => [cell, texts[i]]).filter(([, text]) => text).map(([cell, text]) => {
        const label = document.createElement("span");
        label.textContent = text;
        label.style.left = `${cell.x / ratio}px`;
        label.style.top = `${cell.y / ratio}px`;
        label.style.maxWidth = `calc(${cell.width / ratio}px - 1.2rem)`;
        return label;
    }));
};

const fillTable = (body, pairs) => body.append(...pairs.map(([name, text]) => {
    const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
    head.scope = "row";
    head.textContent = name;
    cell.textContent = text;
    row.append(head, cell);
    return row;
}));
