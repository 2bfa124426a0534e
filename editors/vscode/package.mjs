// Makes build/editors/snell.vsix, of the version that CMakeLists.txt has.
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import vsce from '@vscode/vsce';

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, '../../build/editors');
const version = /^project\(snell VERSION (\S+)/m.exec(readFileSync(join(here, '../../CMakeLists.txt'), 'utf8'))[1];
mkdirSync(out, { recursive: true });
await vsce.createVSIX({
    cwd: here,
    packagePath: join(out, 'snell.vsix'),
    version,
    updatePackageJson: false,
    gitTagVersion: false,
    dependencies: false,
    allowMissingRepository: true,
});
