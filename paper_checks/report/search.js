// Search on every page: the index below is written by the report; nothing is fetched.
const INDEX = {{ index }};
const plain = text => text.toLowerCase().replace(/\\(hat|dot|ddot|tilde|text|mathrm|left|right)\b/g, "").replace(/[{}\\$()]/g, "");
const box = document.getElementById("search"), found = document.getElementById("found");
function search() {
  const words = box.value.split(/\s+/).map(plain).filter(Boolean);
  found.hidden = !words.length;
  if (!words.length) return;
  const hits = INDEX.filter(entry => words.every(word => entry.text.includes(word)));
  hits.sort((a, b) => (plain(b.id).endsWith(":" + words[0]) - plain(a.id).endsWith(":" + words[0])));
  found.replaceChildren(...hits.slice(0, 40).map(hit => {
    const link = document.createElement("a");
    link.href = hit.page + "#" + hit.id;
    link.textContent = hit.id + "  " + hit.title + "  (" + hit.verdict + ")";
    return link;
  }));
  const note = document.createElement("p");
  note.textContent = hits.length ? hits.length + " statements" : "Nothing found.";
  found.prepend(note);
}
box.addEventListener("input", search);
document.addEventListener("click", event => {
  const copy = event.target.closest("button.copy");
  if (copy) { navigator.clipboard?.writeText(copy.parentElement.querySelector("pre").textContent); copy.textContent = "copied"; }
});
const filter = document.getElementById("filter");
if (filter) filter.addEventListener("change", () => {
  let shown = 0;
  for (const card of document.querySelectorAll("[data-verdict]")) {
    card.hidden = filter.value !== "" && card.dataset.verdict !== filter.value;
    shown += !card.hidden;
  }
  document.getElementById("filtered").textContent = shown ? shown + " shown" : "Nothing found.";
});
