"use strict";
// The page of a class: how pictures are compared, and the table's order. Everything is readable without it.

const modes = [["side by side", ""], ["swap", "swap"], ["wipe", "wipe"], ["difference", "difference"], ["heat map", "heat"]];

function addComparison() {
    if (!document.querySelector(".compared")) return;
    const bar = document.createElement("div");
    bar.className = "modes";
    bar.setAttribute("role", "group");
    bar.setAttribute("aria-label", "How pictures are compared");
    for (const [words, mode] of modes) {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = words;
        button.dataset.mode = mode;
        button.addEventListener("click", () => setMode(mode));
        bar.append(button);
    }
    document.querySelector("header nav").after(bar);
    for (const pair of document.querySelectorAll(".compared")) {
        const wipe = document.createElement("input");
        wipe.type = "range";
        wipe.className = "wipe";
        wipe.value = 50;
        wipe.setAttribute("aria-label", "where the reference ends");
        wipe.addEventListener("input", () => pair.style.setProperty("--wipe", `${wipe.value}%`));
        pair.append(wipe);
        pair.addEventListener("click", event => {
            if (document.body.dataset.mode !== "swap" || !event.target.closest(".shown")) return;
            event.preventDefault();
            pair.classList.toggle("swapped");
        });
    }
    document.addEventListener("keydown", event => {
        if (event.target.closest("input, textarea") || event.ctrlKey || event.metaKey || event.altKey) return;
        const index = "bswdh".indexOf(event.key);
        if (index >= 0) setMode(modes[index][1]);
    });
    setMode("");
}

function setMode(mode) {
    document.body.dataset.mode = mode;
    for (const pair of document.querySelectorAll(".compared")) pair.classList.remove("swapped");
    for (const button of document.querySelectorAll(".modes button"))
        button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
}

function sortKey(cell) {
    const text = cell ? cell.textContent.trim() : "";
    const number = parseFloat(text);
    return Number.isNaN(number) ? [1, text.toLowerCase()] : [0, number];
}

function addSorting() {
    const table = document.querySelector(".overview");
    if (!table) return;
    const body = table.tBodies[0];
    [...table.tHead.rows[0].cells].forEach((head, column) => {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "sort";
        button.textContent = head.textContent;
        head.textContent = "";
        head.append(button);
        button.addEventListener("click", () => {
            const falls = head.getAttribute("aria-sort") === "ascending";
            for (const each of table.tHead.rows[0].cells) each.removeAttribute("aria-sort");
            head.setAttribute("aria-sort", falls ? "descending" : "ascending");
            const rows = [...body.rows].map(row => [sortKey(row.cells[column]), row]);
            rows.sort(([a], [b]) => (a[0] - b[0] || (a[1] < b[1] ? -1 : a[1] > b[1] ? 1 : 0)) * (falls ? -1 : 1));
            body.append(...rows.map(([, row]) => row));
        });
    });
    const filter = document.createElement("input");
    filter.type = "search";
    filter.className = "filter";
    filter.placeholder = "show only rows with these words";
    filter.setAttribute("aria-label", filter.placeholder);
    filter.addEventListener("input", () => {
        const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
        for (const row of body.rows) {
            const text = row.textContent.toLowerCase();
            row.hidden = !words.every(word => text.includes(word));
            const link = row.querySelector("a");
            const card = link && document.getElementById(link.hash.slice(1));
            if (card) card.hidden = row.hidden;
        }
    });
    table.before(filter);
}

// j and k go to the next and to the previous submission that is shown, n to the next one that has a field to mark.
function goTo(step, isWanted = () => true) {
    const cards = [...document.querySelectorAll(".card")].filter(each => !each.hidden);
    const now = document.activeElement.closest(".card");
    const at = now ? cards.indexOf(now) : step > 0 ? -1 : cards.length;
    for (let i = at + step; i >= 0 && i < cards.length; i += step) {
        if (!isWanted(cards[i])) continue;
        cards[i].tabIndex = -1;
        cards[i].scrollIntoView({block: "start"});
        cards[i].focus({preventScroll: true});
        const field = cards[i].querySelector("tr.open input");
        if (field && isWanted === hasOpen) field.focus({preventScroll: true});
        return;
    }
}

const hasOpen = card => card.querySelector("tr.open") !== null;

document.addEventListener("keydown", event => {
    const field = event.target.closest("input, textarea");
    if (event.metaKey || event.ctrlKey || (field && !event.altKey)) return;
    const key = event.key.toLowerCase();
    if (key === "j") goTo(1);
    else if (key === "k") goTo(-1);
    else if (key === "n") goTo(1, hasOpen);
    else return;
    event.preventDefault();
});

addComparison();
addSorting();
