#include "meanings.hpp"

#include <algorithm>
#include <array>

#include "../grammar/words.hpp"

namespace rotconv::cli {
namespace {

// clang-format off
constexpr auto meanings = std::to_array<Meaning>({
    // representations
    {"rotationmatrix rotation rot rotm mat r so3", "dcm", ""},
    {"ep eulerparameters versor qw w", "quat", ""},
    {"angleaxis", "axis-angle", "nx ny nz angle: the angle comes last"},
    {"rv expmap log", "rotvec", ""},
    {"taitbryan", "ypr", ""},
    {"cardan", "euler:XYZ", ""},
    {"rot6d rotation6d", "6d", ""},
    {"rodrigues rodriguesvector", "cayley | rotvec", "two meanings: tan(theta/2) n is cayley, theta n (as in OpenCV) is rotvec"},
    {"m2eul eul2m", "", "m2eul(r, 3, 2, 1) is euler:XYZ with its numbers in reverse order: euler:zyx, except at gimbal lock; C-matrices are dcm:spice"},
    {"rollpitchyaw roll pitch yaw", "rpy", ""},
    {"euler eul eulerangles", "rpy | euler:ZYX", "roll pitch yaw are rpy, yaw pitch roll euler:ZYX; other sequences: rotconv list euler"},
    {"heading", "", "the last number of rpy, or the first of euler:ZYX (yaw, pitch, roll)"},
    {"all everything", "-", "without -t, VALUEs are written in every representation"},
    {"homochoric cubochoric ho cu", "", "not here; the homochoric vector of axis n and angle t is (3 (t - sin t) / 4)^(1/3) n"},
    {"se3 homogeneous matrix4 4x4", "dcm", "of a 4x4, row by row, rotconv reads the rotation"},
    {"dualquaternion dq", "", "not here: rotconv converts rotations"},
    {"x y z", "", "a sequence has three letters; a turn about one axis is axis-angle, such as 0 0 1 ANGLE about z", false, true},
    // modifiers
    {"scalarlast last", ":xyzw", ""},
    {"scalarfirst first hamilton", ":wxyz", ""},
    {"inv transpose transposed t conj", ":passive", "SPEC:passive is the inverse"},
    {"columnmajor colmajor columns", ":col", ""},
    {"degrees degree deg ° º", ":deg", "degrees are :deg after the name of the SPEC, as in rpy:deg, or -d"},
    {"radians radian rad", "-", "radians are what angles are in without :deg or -d"},
    {"lefthanded righthanded handedness lefthand righthand mirror flip", "", "numbers of left-handed axes are read by the same formulas; to right-handed ones, for example: --reference-axes ruf:flu --body-axes ruf:flu"},
    {"nb active rowmajor row numpy", "-", "that is what numbers are without a modifier"},
    {"shadow", "-", "an mrp has norm at most 1; --continuous passes to the shadow where that is nearer"},
    {"intrinsic rotating moving", ":upper", "letters in upper case turn about the body's own axes (intrinsic), in lower case about the fixed axes (extrinsic)"},
    {"extrinsic static fixed", ":lower", "letters in upper case turn about the body's own axes (intrinsic), in lower case about the fixed axes (extrinsic)"},
    {"gon grad grads gradian gradians", "", "not here: angles are in radians or, with :deg, in degrees; 1 gon is 0.9 degrees"},
    {"unit units u", ":ARG", "angles are in degrees with :deg after the name of a SPEC or with -d, otherwise in radians; times have --time-unit"},
    // axes
    {"nedtoenu ned2enu", "--reference-axes ned:enu", "a body in FRD, to FLU: --body-axes frd:flu"},
    {"enutoned enu2ned", "--reference-axes enu:ned", ""},
    {"frdtoflu frd2flu", "--body-axes frd:flu", ""},
    {"flutofrd flu2frd", "--body-axes flu:frd", ""},
    {"axes frame frames fromframe toframe ned enu frd flu rdf rub fru ruf luf nwu esu", ":ARG", "NED to ENU is --reference-axes ned:enu, FRD to FLU --body-axes frd:flu, an OpenCV camera to OpenGL --body-axes rdf:rub: three letters say where x, y and z point"},
    // options
    {"pretty", "--format pretty", ""},
    {"silent nowarnings", "--diagnostics off", ""},
    {"showfailures failures verbose", "--diagnostics rows", "compare has --worst N, and --format csv with every pair"},
    {"scalar quaternionorder", ":ARG", "the order of a quaternion is part of its SPEC: quat:wxyz, quat:xyzw"},
    {"sequence seq s order axesorder rotationorder eulerorder eulersequence", ":ARG", "a sequence is part of the SPEC: euler:ZYX about the body's own axes, euler:zyx about the fixed axes"},
    {"outputformat oformat", "-t ARG | --format ARG", "--format is that of the rows; the representation is -t"},
    {"in infile gyro imu", "-i ARG | -f ARG", ""},
    {"out outfile", "-t ARG | -o ARG", ""},
    {"file filename path csv data values value numbers estimate estimated est trajectory actual", "ARG", ""},
    {"decimal decimalcomma decimalseparator", "- | - -", ""},
    {"overwrite force", "-", "-o writes over a FILE that is there"},
    {"inplace", "", "not here: -o FILE is the file to write, and it cannot be the one that is read"},
    {"keep keepcolumns passthrough addcolumns", "--append", "other columns are kept without it"},
    {"digits", "--precision", ""},
    {"withinp95 percentile percentiles p95 quantile", "", "--within 0.3deg@95 holds for 95 rows in 100"},
    {"round places", "--decimals", ""},
    {"sep separator fs F", "--delimiter", ""},
    {"noheader", "--header no", ""},
    {"skipheader hasheader headerrow", "- | - -", "a header is found by itself; --header yes or no says whether there is one"},
    {"skiprows skiplines", "tail", "tail -n +N leaves out lines"},
    {"skip", "tail | --on-error skip", "tail -n +N leaves out lines, --on-error skip rows that have no result"},
    {"skiperrors ignoreerrors ignorenan dropna", "--on-error skip", ""},
    {"fields usecols", "--columns", ""},
    {"maxerror maxangle threshold limit max tol", "--within", "rotconv compare --within ANGLE says which angle passes"},
    {"pair sync match join timestamp time", "--key", "rotconv compare: FILE and REFERENCE by the key, or time, in that column"},
    {"reference ref groundtruth gt truth expected baseline", "REFERENCE", "REFERENCE is the second FILE: rotconv compare -f SPEC FILE REFERENCE"},
    {"rpe", "--delta", "an option of rotconv compare"},
    {"ape ate", "compare", "rotconv compare -f SPEC FILE REFERENCE prints it for rotations; --align turns FILE first", true},
    {"unwrap continuous", "--continuous", "", true},
    {"vector vec v", "rotate @ARG | @ARG", "vectors are turned by rotconv rotate, in whose rows they follow the attitude"},
    {"rotate", "rotate @ARG", "vectors are turned by rotconv rotate, in whose rows they follow the attitude"},
    {"q0 initialattitude x0", "--initial quat:~ARG", "--initial has its SPEC: \"quat: 1 0 0 0\""},
    {"binary bin", "--input-format f64", ""},
    {"then", "--left FROM:~ARG", "L R, about the reference axes; --right is R S, about the body's own"},
    {"n num count", "--rows ARG", ""},
    {"list l representations formats", "list", ""},
    {"robots robot vendors tools programs software", "projects | list projects", ""},
    {"version", "--version", ""},
    {"rms rmse statistics stats", "-", "rotconv compare -f SPEC FILE REFERENCE prints it with its other figures"},
    {"junit", "", "not here: the exit status of rotconv compare --within says whether a check holds, --format json the figures"},
    {"dt step timestep", "awk", "times are a column of the rows, in seconds or in the unit of --time-unit"},
    {"inertia torque dynamics", "", "not here: rotconv integrates angular velocities, which its rows give, and knows no torques"},
    {"kindscolumn", "", "a run a kind, such as rotconv sample -t SPEC --kind lock"},
    {"dtype f32 float32 float single double", "", "binary rows are doubles, f64; those of floats: NumPy's astype('<f8')"},
    // verbs
    {"inverse invert conjugate", "-t FROM:passive | :passive | -f quat -t quat:passive | -f quat:xyzw -t quat:xyzw:passive", ":passive on one side inverts", true},
    {"mul multiply mult product concat concatenate combine chain", "compose", "", true},
    {"relative as", "compose :passive --by FROM -t FROM", "REFERENCE comes first: rotconv compose -f SPEC:passive --by SPEC -t SPEC REFERENCE FILE", true},
    {"diff difference delta subtract sub angle anglebetween distance dist geodesic cmp equal equals same", "compare", "compare gives angles; for the attitudes between them: rotconv compose -f SPEC:passive --by SPEC -t SPEC REFERENCE FILE", true},
    {"check validate verify test", "compare | --strict", "two files are compared; whether numbers are attitudes is what --strict tells", true},
    {"align register", "compare --align reference", "--align also takes body, both, yaw and first", true},
    {"misorientation disorientation symmetry", "compare", "the symmetry of crystals is not here", true},
    {"slerp squad interpolate interp lerp resample", "", "rotconv compose and compare take a REFERENCE between its rows, with --key COLUMN --interpolate; else SciPy's Slerp", true},
    {"average mean avg median filter smooth", "", "not here: rotconv takes each row by itself; SciPy's Rotation.mean()", true},
    {"normalize normalise norm orthogonalize orthonormalize", "--tolerance inf", "every conversion does", true},
    {"random rand generate samples", "sample --kind uniform", "", true},
    {"plot draw show view visualize", "", "not here: rotconv writes numbers; --format pretty is for people", true},
    {"apply transform", "rotate", "", true},
    {"guess detect infer autodetect recognize recognise whichconvention", "identify", "identify needs rows that also have the attitude in a known convention", true},
    {"to into", "-t ARG", "", true},
    {"convert conversion conv", "-", "the conversion has no name", true},
    {"integrate", "propagate", "", true},
    {"derivative differentiate velocity rate angvel angularvelocity angularvelocities bodyrates", "rates --differences", "", true},
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
