/* elements.js - an element of the page, or of a drawing, with its attributes. */
'use strict';
(() => {
function added(element, parent, attributes) {
    for (const name in attributes)
        if (name === 'text') element.textContent = attributes[name];
        else element.setAttribute(name, attributes[name]);
    return parent.appendChild(element);
}
self.made = (tag, parent, attributes) =>
    added(document.createElement(tag), parent, attributes);
self.drawn = (tag, parent, attributes) =>
    added(document.createElementNS('http://www.w3.org/2000/svg', tag), parent, attributes);
/* 1e12 instead of 1000000000000. */
self.shortNumber = number => {
    const value = Number(Number(number).toPrecision(6)), size = Math.abs(value);
    const far = size >= 1e6 || (size < 1e-3 && size > 0);
    return (far ? value.toExponential() : String(value)).replace('e+', 'e');
};
})();
