// Order of the search: a page that has the word in its title, then guides and tutorials, then theory; last the lists and
// the pages of single names, which mention every word.
var Scorer = {
  score: (result) => {
    const [page, , , , score] = result;
    const isList = /^(reference|auto_gallery|maintainers)\/|^(api|parity|bibliography|changelog|trust)$/.test(page);
    const isGuide = /^tutorials\/|^(introduction|quickstart|command_line|coming_from|testing|tables|certified)$/.test(page);
    return score + (isList ? -200 : isGuide ? 5 : 0);
  },
  objNameMatch: 11, objPartialMatch: 6, objPrio: { 0: 15, 1: 5, 2: -5 }, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
