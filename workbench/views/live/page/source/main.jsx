// SPDX-License-Identifier: MIT
// Starts the page: connects to the server that sent it.
import "uplot/dist/uPlot.min.css";

import { render } from "preact";

import { App } from "./app.jsx";
import { connect } from "./robot.js";
import "./style.css";
import { applyTheme } from "./theme.js";

applyTheme();
connect(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/`);
render(<App />, document.getElementById("app"));
