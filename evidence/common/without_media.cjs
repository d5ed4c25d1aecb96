// Playwright sets the colour scheme of every page, by a command that Firefox ESR 153 does not know: it does nothing here.
const { Module } = require("module");
const compile = Module.prototype._compile;
Module.prototype._compile = function (text, name) {
  const known = text.replaceAll('"emulation.setMediaFeaturesOverride"', '"session.status"');
  return compile.call(this, name.endsWith("coreBundle.js") ? known : text, name);
};
