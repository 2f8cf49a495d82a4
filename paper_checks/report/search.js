// Search on every page: the index and the words below are written by the report; nothing is fetched.
// The rules are those of asymptotics/papers/search.py, which the command `asymptotics papers` follows.
const INDEX = {{ index }};
const WORDS = {{ words }};
const box = document.getElementById("search"), found = document.getElementById("found");

function plain(text) {
  text = [...text].map(letter => WORDS.greek[letter] ?? letter).join("").replace(new RegExp(WORDS.marks, "g"), "");
  text = text.replace(/\\[td]?frac\{([^{}]*)\}\{([^{}]*)\}/g, "$1/$2").replace(/[{}\\$]/g, "");
  return text.replace(/\s*=\s*/g, "=").toLowerCase().trim();
}

function reduced(query) {
  let text = plain(query).replace(/\btable\.?\s*(i{1,3}|iv|v|\d+)\b/g, (_, number) => "table" + (WORDS.roman[number] ?? number));
  text = text.replace(/\bfig(?:ure|\.)?\s*(\d)/g, "fig$1").replace(/\b(?:footnote|fn\.?)\s*(\d)/g, "fn$1");
  text = text.replace(/\b(?:eqs?|eqn|equation)\.?\s*\(?(\d)/g, " $1");
  const words = text.split(/[\s,;]+/).map(word => word.replace(/^[.,;:()?'"]+|[.,;:()?'"]+$/g, ""));
  const author = word => WORDS.authors[word.replace(/'s$/, "")], named = words.map(author).filter(Boolean);
  const idle = word => WORDS.idle.includes(word) || author(word) || (named.length && WORDS.years.includes(word));
  return [named, words.filter(word => word && !idle(word)).map(word => WORDS.also[word] ?? word)];
}

function marks(entry, word) {
  const own = entry.id.slice(entry.id.indexOf(":") + 1).toLowerCase();
  if (own === word || entry.id.toLowerCase() === word) return 100;
  if (own.startsWith(word + ".") || own === "claim." + word) return 60;
  const lead = entry.formula.startsWith(word) ? 6 : 0;
  const whole = new RegExp("(?<![\\w/])" + word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&") + "(?![\\w/])");
  if (whole.test(entry.plain) || entry.said.split(/\s+/).includes(word)) return 8 + lead;
  if (whole.test(entry.formula)) return 4 + lead;
  return entry.plain.includes(word) ? 5 : entry.formula.includes(word) ? 2 : (entry.notes + " " + own).includes(word) ? 1 : 0;
}

function ranked(query) {
  const [named, words] = reduced(query), chosen = INDEX.filter(entry => !named.length || named.includes(entry.id.split(":")[0]));
  if (!words.length) return named.length ? chosen : [];
  const hits = [];
  for (const entry of chosen) {
    const each = words.map(word => marks(entry, word)), fit = each.filter(Boolean).length;
    if (fit) hits.push([each.reduce((a, b) => a + b, 1000 * fit), entry]);
  }
  hits.sort((a, b) => b[0] - a[0]);
  const most = hits.length ? Math.floor(hits[0][0] / 1000) : 0, fullest = hits.filter(hit => Math.floor(hit[0] / 1000) === most);
  const exact = fullest.filter(hit => hit[0] >= 1100 * words.length);
  return (exact.length ? exact : fullest).map(hit => hit[1]);
}

function search() {
  found.hidden = !box.value.trim();
  if (found.hidden) return;
  const hits = ranked(box.value);
  found.replaceChildren(...hits.slice(0, 40).map(hit => {
    // The pages of the documentation are made by another command: they are named, not linked.
    const link = document.createElement(hit.page ? "a" : "span");
    if (hit.page) link.href = hit.page + "#" + (hit.anchor || hit.id);
    link.textContent = (hit.shown || hit.id) + "  " + hit.title + (hit.verdict ? "  (" + hit.verdict + ")" : "");
    return link;
  }));
  const note = document.createElement("p");
  note.textContent = hits.length ? hits.length + " found" : "Nothing found.";
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
