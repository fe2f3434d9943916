/* What a page does beyond showing itself: remembers the language, sorts the table of marks. Without it
   everything can still be read. */
"use strict";

(function () {
  const languages = ["en", "es"];

  /* Storage may be forbidden on file://, so what is remembered may be forgotten. */
  function remembered() {
    try {
      return localStorage.getItem("meshgrade-language");
    } catch (error) {
      return null;
    }
  }

  function remember(language) {
    try {
      localStorage.setItem("meshgrade-language", language);
    } catch (error) {
      /* the switch still works for this page */
    }
  }

  /* Texts in attributes come as name="English" data-es-name="Spanish". */
  function translate(language) {
    document.documentElement.lang = language;
    for (const name of ["alt", "title", "aria-label"]) {
      for (const element of document.querySelectorAll("[data-es-" + name + "]")) {
        if (!element.hasAttribute("data-en-" + name))
          element.setAttribute("data-en-" + name, element.getAttribute(name));
        element.setAttribute(name, element.getAttribute("data-" + language + "-" + name));
      }
    }
  }

  function start_languages() {
    const wanted = remembered() || (navigator.language || "en").slice(0, 2);
    const first = languages.includes(wanted) ? wanted : "en";
    for (const language of languages) {
      const button = document.getElementById("language-" + language);
      button.checked = language === first;
      button.addEventListener("change", function () {
        remember(language);
        translate(language);
      });
    }
    translate(first);
  }

  function value_of(row, column) {
    const cell = row.cells[column];
    const number = cell.dataset.value;
    return number === undefined ? cell.textContent.trim() : Number(number);
  }

  function compare(a, b) {
    return typeof a === "number" ? a - b : a.localeCompare(b);
  }

  function sort(table, column, header) {
    const ascending = header.getAttribute("aria-sort") !== "ascending";
    const body = table.tBodies[0];
    const rows = Array.from(body.rows);
    rows.sort(function (a, b) {
      const order = compare(value_of(a, column), value_of(b, column));
      return ascending ? order : -order;
    });
    body.append(...rows);
    for (const other of header.parentElement.cells) other.setAttribute("aria-sort", "none");
    header.setAttribute("aria-sort", ascending ? "ascending" : "descending");
  }

  function start_sorting(table) {
    Array.from(table.tHead.rows[0].cells).forEach(function (header, column) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "sort";
      button.append(...header.childNodes);
      header.append(button);
      header.setAttribute("aria-sort", "none");
      button.addEventListener("click", function () {
        sort(table, column, header);
      });
    });
  }

  /* What an address names may lie in a part that is closed. */
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
    if (target) target.scrollIntoView();
  }

  start_languages();
  document.querySelectorAll("table.sortable").forEach(start_sorting);
  window.addEventListener("hashchange", reveal);
  reveal();
  document.documentElement.dataset.page = "ready";
})();
