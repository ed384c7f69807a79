#include "meanings.hpp"

#include <algorithm>
#include <array>

#include "words.hpp"

namespace rotconv::cli {
namespace {

// clang-format off
constexpr auto meanings = std::to_array<Meaning>({
    // representations
    {"rotmat rotationmatrix rotation rot mat r so3", "dcm", ""},
    {"q ep eulerparameters versor qw w", "quat", ""},
    {"aa angleaxis", "axis-angle", "(nx ny nz angle: the angle comes last)"},
    {"rotationvector rv prv expmap log", "rotvec", ""},
    {"ypr yawpitchroll taitbryan", "euler:ZYX", ""},
    {"cardan", "euler:XYZ", ""},
    {"crp", "cayley", ""},
    {"rot6d rotation6d", "6d", ""},
    {"rodrigues rodriguesvector", "", "two meanings: tan(theta/2) n is cayley, theta n (as in OpenCV) is rotvec"},
    {"m2eul eul2m", "", "m2eul(r, 3, 2, 1) is euler:XYZ with its numbers in reverse order: euler:zyx, except at gimbal lock; C-matrices are dcm:spice"},
    {"rollpitchyaw roll pitch yaw", "rpy", ""},
    {"euler eul eulerangles", "euler:ZYX", "(or another sequence: rotconv list euler)"},
    {"heading", "", "the last number of rpy, or the first of euler:ZYX (yaw, pitch, roll)"},
    {"all everything", "", "without -t, VALUEs are written in every representation"},
    {"homochoric cubochoric ho cu", "", "not here; the homochoric vector of axis n and angle t is (3 (t - sin t) / 4)^(1/3) n"},
    {"dualquaternion dq se3 homogeneous matrix4 4x4", "", "not here: rotconv converts rotations; that of a 4x4, row by row, is dcm --columns 1-3,5-7,9-11"},
    {"x y z", "", "a sequence has three letters; a turn about one axis is axis-angle, such as 0 0 1 ANGLE about z", false, true},
    // modifiers
    {"scalarlast last", "xyzw", ""},
    {"scalarfirst first hamilton", "wxyz", ""},
    {"inv transpose transposed t conj", "passive", "(the inverse)"},
    {"columnmajor colmajor columns", "col", ""},
    {"degrees degree deg ° º", "", "degrees are :deg after the name of the SPEC, as in rpy:deg, or -d"},
    {"radians radian rad", "", "radians are what angles are in without :deg or -d: leave it out"},
    {"lefthanded righthanded handedness lefthand righthand mirror flip", "", "numbers of left-handed axes are read by the same formulas; to right-handed ones, for example: --reference-axes ruf:flu --body-axes ruf:flu"},
    {"nb active rowmajor row numpy", "", "that is what numbers are without a modifier: leave it out"},
    {"shadow", "", "an mrp has norm at most 1; --continuous passes to the shadow where that is nearer"},
    {"intrinsic extrinsic rotating static moving fixed", "", "letters in upper case turn about the body's own axes (intrinsic), in lower case about the fixed axes (extrinsic): euler:ZYX, euler:zyx"},
    {"gon grad grads gradian gradians", "", "not here: angles are in radians or, with :deg, in degrees; 1 gon is 0.9 degrees"},
    {"unit units", "", "angles are in degrees with :deg after the name of a SPEC or with -d, otherwise in radians; times have --time-unit"},
    // axes
    {"axes frame frames fromframe toframe nedtoenu enutoned frdtoflu flutofrd ned2enu enu2ned ned enu frd flu rdf rub fru ruf luf nwu esu", "", "NED to ENU is --reference-axes ned:enu, FRD to FLU --body-axes frd:flu, an OpenCV camera to OpenGL --body-axes rdf:rub: three letters say where x, y and z point"},
    // options
    {"json", "--format json", ""},
    {"pretty", "--format pretty", ""},
    {"quiet silent nowarnings", "--diagnostics off", ""},
    {"showfailures failures verbose", "--diagnostics rows", "(compare: --worst N, or --format csv with every pair)"},
    {"sequence seq order axesorder rotationorder eulerorder eulersequence", "", "a sequence is part of the SPEC: euler:ZYX about the body's own axes, euler:zyx about the fixed axes"},
    {"outputformat oformat", "--format", "(of the rows; the representation is -t)"},
    {"in infile out outfile", "", "a file to read is a word without an option, or -i FILE; -o FILE is the file to write"},
    {"inplace overwrite", "", "not here: -o FILE is the file to write, and it cannot be the one that is read"},
    {"keep keepcolumns passthrough addcolumns", "--append", "(other columns are kept without it)"},
    {"digits", "--precision", ""},
    {"withinp95 percentile percentiles p95 quantile", "--within ANGLE@PERCENT", "(--within 0.3deg@95: of 95 in 100)"},
    {"as relative", "compose", "(rotconv compose -f quat:passive --by quat REFERENCE FILE)"},
    {"round places", "--decimals", ""},
    {"sep separator fs F", "--delimiter", ""},
    {"noheader", "--header no", ""},
    {"skipheader hasheader headerrow skiprows", "", "a header is found by itself; --header yes or no says whether there is one, and tail -n +N leaves out lines"},
    {"skip skiperrors ignoreerrors ignorenan dropna", "--on-error skip", ""},
    {"fields cols usecols c", "--columns", ""},
    {"maxerror maxangle threshold limit", "--within", "(rotconv compare)"},
    {"pair sync match join timestamp time", "--key", "(rotconv compare: FILE and REFERENCE by the key, or time, in that column)"},
    {"reference ref", "", "REFERENCE is the second FILE: rotconv compare -f SPEC FILE REFERENCE"},
    {"rpe", "--delta", "(rotconv compare)"},
    {"ape ate", "", "rotconv compare -f SPEC FILE REFERENCE prints it for rotations; --align turns FILE first"},
    {"unwrap continuous", "--continuous", "(rotconv -f SPEC -t SPEC --continuous)", true},
    {"list l representations formats", "rotconv list", ""},
    {"robots robot vendors tools programs software", "rotconv list projects", ""},
    {"version", "rotconv --version", ""},
    {"rms statistics stats", "", "rotconv compare -f SPEC FILE REFERENCE prints it with its other figures"},
    {"junit", "", "not here: the exit status of rotconv compare --within says whether a check holds, --format json the figures"},
    {"dt step timestep rate frequency", "", "not here: times are a column of the rows, in seconds or in the unit of --time-unit"},
    {"inertia torque dynamics", "", "not here: rotconv integrates angular velocities, which its rows give, and knows no torques"},
    {"kindscolumn", "", "a run a kind, such as rotconv sample -t SPEC --kind lock"},
    {"dtype f32 float32 float single double", "", "binary rows are doubles, f64; those of floats: NumPy's astype('<f8')"},
    // verbs
    {"inverse invert conjugate", "", ":passive on one side inverts, as in rotconv -f quat -t quat:passive", true},
    {"mul multiply mult product concat concatenate combine chain", "", "--left and --right multiply by one attitude; two streams A and B are multiplied by rotconv compose -f SPEC -t SPEC A B", true},
    {"diff difference delta subtract sub relative angle distance geodesic", "", "rotconv compare -f SPEC FILE REFERENCE prints angles; the attitudes between them: rotconv compose -f SPEC:passive --by SPEC -t SPEC REFERENCE FILE", true},
    {"check validate verify test", "", "rotconv compare -f SPEC --within ANGLE FILE REFERENCE; whether numbers are attitudes: rotconv -f SPEC -t SPEC --strict FILE", true},
    {"align register", "", "rotconv compare -f SPEC --align SIDE FILE REFERENCE", true},
    {"misorientation disorientation symmetry", "", "rotconv compare -f SPEC FILE REFERENCE prints the angle between attitudes; the symmetry of crystals is not here", true},
    {"slerp squad interpolate interp lerp resample", "", "not here: SciPy's Slerp; rotconv compare takes a REFERENCE between its rows, with --key COLUMN --interpolate", true},
    {"average mean avg median filter smooth", "", "not here: rotconv takes each row by itself; SciPy's Rotation.mean()", true},
    {"normalize normalise norm orthogonalize orthonormalize", "", "every conversion does, with --tolerance inf", true},
    {"random rand generate samples", "", "rotconv sample -t SPEC --kind uniform", true},
    {"plot draw show view visualize", "", "not here: rotconv writes numbers; --format pretty is for people", true},
    {"apply transform", "", "rotconv rotate -f SPEC", true},
    {"guess detect infer autodetect recognize recognise whichconvention", "", "rotconv identify -t KNOWN FILE, whose rows also have the attitude in a known convention", true},
    {"convert conversion conv", "", "it has no name: rotconv -f SPEC -t SPEC", true},
    {"integrate", "", "rotconv propagate", true},
    {"derivative differentiate velocity", "", "rotconv rates --differences", true},
    // what stands beside numbers
    {"− – — －", "", "write the minus sign as -, the one of the keyboard"},
    {"pi π mpi np math", "", "write pi as 3.141592653589793, or angles in degrees, with :deg after the name of the SPEC"},
    {"i j k", "", "a quaternion is its four numbers alone: w x y z, or with :xyzw x y z w"},
});
// clang-format on

} // namespace

const Meaning* find_meaning(std::string_view word) {
    const std::string plain = without_marks(lower(word));
    const auto* const found = std::ranges::find_if(meanings, [&](const Meaning& meaning) {
        const auto words = words_in(meaning.words);
        const bool is_whole = plain.size() > 1 || word.size() == 1; // not the t of -t
        return (is_whole && std::ranges::count(words, plain) > 0) || std::ranges::count(words, word) > 0;
    });
    return found == meanings.end() ? nullptr : &*found;
}

} // namespace rotconv::cli
