// Draws the page of what the program has put into it.
import { has, json } from "./shared/data.js";
import { runPage } from "./run/run_page.js";
import { sweepPage } from "./sweep/sweep_page.js";

const began = performance.now();
const root = document.getElementById("page");
if (has("run")) runPage(root, json("run"));
else if (has("sweep")) sweepPage(root, json("sweep"));
document.documentElement.dataset.ready = String(Math.round(performance.now() - began));
