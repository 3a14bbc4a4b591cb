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
