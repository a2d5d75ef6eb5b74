// What a narrow screen begins with: the robot and STOP, the panels put away.

export const onPhone = () => matchMedia('(max-width: 700px)').matches;

// hidePanels: as the button does.
export function beginOnPhone(hidePanels) {
  if (onPhone()) hidePanels();
}
