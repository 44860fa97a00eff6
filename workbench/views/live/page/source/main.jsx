// SPDX-License-Identifier: MIT
// Starts the page: connects to the server that sent it.
import "uplot/dist/uPlot.min.css";

import { render } from "preact";

import { App } from "./app.jsx";
import { connect } from "./robot.js";
import "./style.css";
import { applyTheme } from "./theme.js";

applyTheme();
// The query of the link contains the token of the run.
connect(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/${location.search}`);
render(<App />, document.getElementById("app"));
