// Copy buttons for commands, line breaks of commands only between words, and printing of folded commands. Without
// this script a page lacks only these.
(() => {
    let printing = false;
    const said = document.getElementById("said");

    // For browsers that deny the clipboard to pages on disk.
    const copyBySelection = (text) => {
        const area = document.createElement("textarea");
        area.value = text;
        area.style.position = "fixed";
        document.body.append(area);
        area.select();
        const copied = document.execCommand("copy");
        area.remove();
        return copied;
    };

    const copy = async (text) => {
        try {
            await navigator.clipboard.writeText(text);
            return true;
        } catch {
            return copyBySelection(text);
        }
    };

    for (const button of document.querySelectorAll("button.copy")) {
        button.hidden = false;
        button.addEventListener("click", async () => {
            const code = button.parentElement.querySelector("code");
            const copied = await copy(code.textContent);
            button.focus();
            button.textContent = copied ? "Copied" : "Selected";
            if (!copied) getSelection().selectAllChildren(code);
            said.textContent = copied ? "The command was copied." : "The command is selected; copy it with the keyboard.";
            setTimeout(() => {
                button.textContent = "Copy";
                said.textContent = "";
            }, 2000);
        });
    }

    // Browsers would break the line after the hyphens of an option.
    for (const code of document.querySelectorAll(".command code")) {
        const words = code.textContent.split(/( +)/).map((word) => {
            const span = document.createElement("span");
            span.textContent = word;
            return word.trim() ? span : word;
        });
        code.replaceChildren(...words);
    }

    // A command that is opened at the far end of a table is scrolled to.
    for (const details of document.querySelectorAll("td details")) {
        details.addEventListener("toggle", () => {
            if (details.open && !printing) details.scrollIntoView({ block: "nearest", inline: "nearest" });
        });
    }

    let opened = [];
    addEventListener("beforeprint", () => {
        printing = true;
        opened = [...document.querySelectorAll("details:not([open])")];
        for (const details of opened) details.open = true;
    });
    addEventListener("afterprint", () => {
        for (const details of opened) details.open = false;
        printing = false;
    });
})();
