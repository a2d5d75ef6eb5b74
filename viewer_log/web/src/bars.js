// The bars at the top and at the bottom have as many lines as they need: panels, sheets and bands follow their edges.
//
// --top: the lower edge of the head [px]; --foot: from the lower edge of the page to the top of chips and STOP [px].

// changed(top, foot): at the beginning and at every change.
export function followBars(head, footer, changed) {
  const root = document.documentElement.style;
  const look = () => {
    const top = Math.ceil(head.getBoundingClientRect().bottom), foot = Math.ceil(innerHeight - footer.getBoundingClientRect().top);
    root.setProperty('--top', `${top}px`);
    root.setProperty('--foot', `${foot}px`);
    changed(top, foot);
  };
  const observer = new ResizeObserver(look);
  observer.observe(head);
  observer.observe(footer);
  addEventListener('resize', look);
  look();
}
