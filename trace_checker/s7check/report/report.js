"use strict";
// Long pictures show their end, where the verdict is.
for (const box of document.querySelectorAll(".scroll"))
  if (box.scrollWidth > 1.4 * box.clientWidth) box.scrollLeft = box.scrollWidth;

// The form picks rows of the table, and the sections of these logs.
const form = document.querySelector("form.filter");
if (form) {
  const [text] = form.querySelectorAll("[type=search]");
  const boxes = [...form.querySelectorAll("[type=checkbox]")];
  const pick = () => {
    const wanted = text.value.toLowerCase();
    const verdicts = new Set(boxes.filter(box => box.checked).map(box => box.value));
    let shown = 0, all = 0;
    for (const body of document.querySelectorAll("table.contents > tbody")) {
      const [head, ...rows] = body.rows;
      const fits = head.textContent.toLowerCase().includes(wanted);
      let some = 0;
      for (const row of rows) {
        const visible = verdicts.has(body.className) && (fits || row.textContent.toLowerCase().includes(wanted));
        row.hidden = !visible;
        const link = row.querySelector("a");
        if (link) document.querySelector(link.getAttribute("href")).hidden = !visible;
        some += visible;
      }
      body.hidden = !some;
      shown += some;
      all += rows.length;
    }
    form.querySelector("output").textContent = `${shown} of ${all} logs`;
  };
  form.addEventListener("input", pick);
  form.addEventListener("submit", event => event.preventDefault());
  form.hidden = false;
  pick();
}
