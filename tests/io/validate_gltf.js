// usage: node validate_gltf.js FOLDER_OF_NODE_MODULES FILE...
// Prints what the Khronos glTF validator has to say against each file; its status is 1 if that is an error or a warning.
const path = require('path'), fs = require('fs');
const validator = require(path.join(process.argv[2], 'gltf-validator'));
async function main() {
    let bad = 0;
    for (const file of process.argv.slice(3)) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {uri: path.basename(file)});
        // 2 is "information": for one, that the validator does not know an extension.
        const severe = report.issues.messages.filter(message => message.severity < 2);
        for (const message of severe) console.log(`${file}: ${message.code} ${message.pointer}: ${message.message}`);
        bad += severe.length;
    }
    process.exit(bad ? 1 : 0);
}
main();
