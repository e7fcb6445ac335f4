import { render } from "preact";
import "./style/base.css";
import "./style/search.css";
import "./style/tools.css";
import "./style/sheets.css";
import "./style/layout.css";
import { App } from "./views/App";

const root = document.getElementById("app");
if (root !== null) render(<App />, root);

// The page opens without a link, too, to say so; where the certificate is not trusted, browsers refuse it.
if ("serviceWorker" in navigator) navigator.serviceWorker.register("/sw.js").catch(() => undefined);
