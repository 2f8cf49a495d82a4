// Order of the search: guides and tutorials before the pages of single names, which mention every word.
var Scorer = {
  score: (result) => {
    const [page, , , , score] = result;
    return /^(reference|auto_gallery)\//.test(page) ? score - 25 : score;
  },
  objNameMatch: 11, objPartialMatch: 6, objPrio: { 0: 15, 1: 5, 2: -5 }, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
