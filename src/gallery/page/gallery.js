// The list of scenes: the search, and films under the pointer.

const search = document.getElementById("search");
const count = document.getElementById("count");
const nothing = document.getElementById("nothing");
const sections = [...document.querySelectorAll("main section")];
const tiles = [...document.querySelectorAll(".tile")];
const all = count.textContent;

// Shows the scenes that have all the words of the search. A scene of several chapters stands there several times and
// counts once.
function show() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = new Set();
    for (const tile of tiles) {
        tile.hidden = !words.every((word) => tile.dataset.text.includes(word));
        if (!tile.hidden) found.add(tile.getAttribute("href"));
    }
    for (const section of sections) section.hidden = [...section.querySelectorAll(".tile")].every((tile) => tile.hidden);
    nothing.hidden = found.size > 0;
    count.textContent = words.length ? `${found.size} of ${all}` : all;
}

search.hidden = false;
search.addEventListener("input", show);
search.addEventListener("keydown", (event) => {
    if (event.key === "Escape") search.value = "";
    if (event.key === "Escape") show();
    if (event.key === "Enter") tiles.find((tile) => !tile.hidden)?.click();
});
document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.target === search || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    search.focus();
});
show();  // a browser keeps what was typed before a page was left

// A film plays while the mouse or the focus is on its scene.
const moves = !matchMedia("(prefers-reduced-motion: reduce)").matches;
for (const image of document.querySelectorAll("img[data-film]")) {
    const still = image.getAttribute("src");
    const tile = image.closest(".tile");
    const play = () => { if (moves) image.src = image.dataset.film; };
    const stop = () => { image.src = still; };
    tile.addEventListener("pointerenter", play);
    tile.addEventListener("pointerleave", stop);
    tile.addEventListener("focus", play);
    tile.addEventListener("blur", stop);
}
