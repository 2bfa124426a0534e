// What pages do not draw as the native program does, by scene.

// Scenes that `snell web` refuses, and what it says. All others have pages.
export const refused = {
    Shp: 'cannot read ESRI shape files',
};

const thin = 'lines of WebGL 2 are one pixel wide';

// Pictures that differ, by the native driver, and why. One that is not needed fails.
export const exceptions = {
    ANGLE: {},
    Mesa: { LineWidth: thin, LinesAdjacency: thin, ObjAdj: thin, glEnd: thin },
};
