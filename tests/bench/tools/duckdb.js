// node duckdb.js: the textbook's formula in SQL, on as many threads as there are processors. `npm install --prefix FOLDER
// @duckdb/node-api` installs the module, NODE_PATH=FOLDER/node_modules says where it is.

const { DuckDBInstance } = require("@duckdb/node-api");

const columns = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"].map((name) => `${name}: 'DOUBLE'`);
const statement = `COPY (
    SELECT degrees(atan2(r32, r33)), degrees(atan2(-r31, sqrt(r32 * r32 + r33 * r33))), degrees(atan2(r21, r11))
    FROM read_csv('/dev/stdin', header = false, auto_detect = false, delim = ',', columns = {${columns}})
) TO '/dev/stdout' (FORMAT csv, HEADER false)`;

(async () => (await (await DuckDBInstance.create()).connect()).run(statement))();
