#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/io/anatomy_set/set_codec.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <algorithm>
#include <map>

namespace carina::anatomy_set_test
{
namespace
{

constexpr double kPlaceTolerance = 1e-6;  // m
constexpr double kVolumeTolerance = 1e-9; // m^3

using test::Tetrahedron;

/// Every file and folder below a folder with its bytes and the time it was last written.
std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>>
contentsOf(const std::filesystem::path& folder)
{
    std::map<std::string, std::pair<std::string, std::filesystem::file_time_type>> contents;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder}) {
        std::string bytes;
        if (entry.is_regular_file()) {
            std::ifstream stream{entry.path(), std::ios::binary};
            bytes.assign(std::istreambuf_iterator<char>{stream}, {});
        }
        contents[entry.path().string()] = {std::move(bytes), entry.last_write_time()};
    }
    return contents;
}

const AnatomyPart* partNamed(const Anatomy& anatomy, const std::string& name)
{
    const auto found = std::find_if(anatomy.parts.begin(), anatomy.parts.end(),
                                    [&](const AnatomyPart& part) { return part.name == name; });
    return found == anatomy.parts.end() ? nullptr : &*found;
}

} // namespace

class TestAnatomySet final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    std::filesystem::path m_set;
    std::filesystem::path m_cache;

    void write(const std::string& name, const std::string& bytes) const
    {
        test::writeFile(m_set / name, bytes);
    }
    Result<LoadedSet> load(CacheUse use = CacheUse::Allowed) const
    {
        return loadAnatomySet(m_set, m_cache, {}, use);
    }

private Q_SLOTS:
    /// Millimetres, LPS. The left lung whole, the right one as a lobe beside the whole.
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_set = m_temporary->path().toStdString() + "/Somebody";
        m_cache = m_temporary->path().toStdString() + "/cache";
        write("airway/Trachea.obj", test::objOf({100.0F, -5.0F, -5.0F, 1300.0F}));
        write("left_lung.stl", test::binaryStlOf({200.0F, 20.0F, -50.0F, 1100.0F}));
        write("right_lung.ply", test::asciiPlyOf({210.0F, -220.0F, -50.0F, 1100.0F}));
        write("right_upper_lobe.ply", test::binaryPlyOf({200.0F, -220.0F, -50.0F, 1100.0F}, true));
        write("Mandible.obj", test::objOf({110.0F, -50.0F, -100.0F, 1500.0F}));
    }

    void movesThePartsIntoTheAnatomyFrame()
    {
        const auto loaded = load();
        QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().detail.c_str());
        const Anatomy& anatomy = loaded->set.anatomy;
        QCOMPARE(anatomy.name, std::string{"Somebody"});
        QCOMPARE(anatomy.contentHash.size(), std::size_t{64});
        QVERIFY(loaded->set.faults.empty());
        QCOMPARE(loaded->set.frame.metresPerUnit, 1e-3);
        QVERIFY(loaded->set.frame.R_AF == Mat3::Identity());
        // Wherever the origin is: the mandible lies as it did beside the trachea.
        const Box trachea = boundsOf(partNamed(anatomy, "Trachea")->levels[0]);
        const Box mandible = boundsOf(partNamed(anatomy, "Mandible")->levels[0]);
        QVERIFY((mandible.min - trachea.min - Vec3{-0.045, -0.095, 0.2}).norm() < kPlaceTolerance);
        QVERIFY((mandible.size() - Vec3::Constant(0.11)).norm() < kPlaceTolerance);
        QVERIFY(anatomy.landmarks.p_A_carina.isZero(kPlaceTolerance));
        for (const AnatomyPart& part : anatomy.parts)
            QVERIFY(part.levels[0].normals.size() == part.levels[0].positions.size());
    }

    void usesLobesWhereTheyAreBesideWholeLungs()
    {
        const auto loaded = load();
        const Anatomy& anatomy = loaded->set.anatomy;
        QCOMPARE(anatomy.parts.size(), std::size_t{4});
        QVERIFY(partNamed(anatomy, "Right upper lobe")->role == PartRole::RightUpperLobe);
        QVERIFY(partNamed(anatomy, "Left lung")->role == PartRole::LeftLung);
        QVERIFY(partNamed(anatomy, "Right lung") == nullptr);
        QCOMPARE(loaded->set.leftOut.size(), std::size_t{1});
        QVERIFY(loaded->set.leftOut[0].starts_with("right_lung.ply"));
    }

    void closesLungsAndTurnsPartsOutward()
    {
        std::string open = test::objOf({200.0F, 20.0F, -50.0F, 1100.0F});
        open.resize(open.rfind('f')); // one triangle less
        std::filesystem::remove(m_set / "left_lung.stl");
        write("left_lower_lobe.obj", open);
        std::string inverted = test::objOf({110.0F, -50.0F, -100.0F, 1500.0F});
        for (std::size_t at = inverted.find("f "); at != std::string::npos;
             at = inverted.find("f ", at + 1))
            std::swap(inverted[at + 2], inverted[at + 4]);
        write("Mandible.obj", inverted);
        const auto loaded = load();
        const TriangleMesh& lobe = partNamed(loaded->set.anatomy, "Left lower lobe")->levels[0];
        QVERIFY(isClosed(lobe));
        QVERIFY(std::abs(signedVolume(lobe) - 0.008 / 6.0) < kVolumeTolerance);
        const TriangleMesh& mandible = partNamed(loaded->set.anatomy, "Mandible")->levels[0];
        QVERIFY(std::abs(signedVolume(mandible) - 0.001331 / 6.0) < kVolumeTolerance);
    }

    void leavesOutWhatIsThereTwice()
    {
        write("z/Mandible again.stl", test::binaryStlOf({110.0F, -50.0F, -100.0F, 1500.0F}));
        write("z/Mandible nearly.stl", test::binaryStlOf({110.5F, -50.0F, -100.0F, 1500.0F}));
        const auto loaded = load();
        QCOMPARE(loaded->set.anatomy.parts.size(), std::size_t{5});
        QCOMPARE(loaded->set.leftOut.size(), std::size_t{2});
        QVERIFY(loaded->set.leftOut[1].starts_with("z/Mandible again.stl"));
    }

    void loadsTheRestOfASetWithBrokenFiles()
    {
        write("empty.obj", "");
        write("cut.stl", test::binaryStlOf({10.0F}).substr(0, 100));
        write("nan.obj", "v nan 0 0\n" + test::objOf({10.0F}));
        std::filesystem::create_symlink("nowhere.ply", m_set / "gone.ply");
        write("MANIFEST.tsv", "group\tfile\tFMA\nairway\tTrachea.obj\tFMA7394\n"
                              "skull\tSkull.obj\tFMA1\r\n");
        for (const bool cached : {false, true}) {
            const auto loaded = load();
            QCOMPARE(loaded->fromCache, cached);
            QCOMPARE(loaded->set.anatomy.parts.size(), std::size_t{4});
            std::map<std::string, Errc> faults;
            for (const FileFault& fault : loaded->set.faults) {
                faults[fault.file] = fault.error.code;
                QVERIFY(fault.error.detail.find(fault.file) != std::string::npos);
            }
            const std::map<std::string, Errc> expected{{"Skull.obj", Errc::FileNotFound},
                                                       {"cut.stl", Errc::FileMalformed},
                                                       {"empty.obj", Errc::FileEmpty},
                                                       {"gone.ply", Errc::FileNotFound},
                                                       {"nan.obj", Errc::NotFinite}};
            QVERIFY(faults == expected);
        }
    }

    void mirrorsBackAMirrorImage()
    {
        write("Axis.obj", test::objOf({40.0F, -20.0F, 150.0F, 1450.0F}));
        for (const char* name : {"airway/Trachea.obj", "Mandible.obj", "left_lung.stl",
                                 "right_lung.ply", "right_upper_lobe.ply", "Axis.obj"})
            std::filesystem::remove(m_set / name);
        const auto mirrored = [](const Tetrahedron& s) { // x turned about
            std::string text;
            const auto p = s.coordinates();
            for (std::size_t i = 0; i < p.size(); i += 3)
                text += "v " + std::to_string(-p[i]) + ' ' + std::to_string(p[i + 1]) + ' '
                        + std::to_string(p[i + 2]) + '\n';
            return text + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
        };
        write("Trachea.obj", mirrored({100.0F, -5.0F, -5.0F, 1300.0F}));
        write("left_lung.obj", mirrored({200.0F, 20.0F, -50.0F, 1100.0F}));
        write("right_lung.obj", mirrored({200.0F, -220.0F, -50.0F, 1100.0F}));
        write("Mandible.obj", mirrored({110.0F, -50.0F, -100.0F, 1500.0F}));
        write("Axis.obj", mirrored({40.0F, -20.0F, 150.0F, 1450.0F}));
        const auto loaded = load();
        QVERIFY(loaded.has_value());
        QCOMPARE(loaded->set.frame.R_AF.determinant(), -1.0);
        const Anatomy& anatomy = loaded->set.anatomy;
        for (const AnatomyPart& part : anatomy.parts)
            QVERIFY(signedVolume(part.levels[0]) > 0.0);
        QVERIFY(boundsOf(partNamed(anatomy, "Left lung")->levels[0]).min.x()
                > boundsOf(partNamed(anatomy, "Right lung")->levels[0]).max.x());
    }

    void collectsAttributions()
    {
        write("SOURCE.txt", "WHAT x\nLICENCE  CC0.\n");
        QCOMPARE(load()->set.anatomy.attributions, std::vector<std::string>{"LICENCE  CC0."});
        write("Mandible.obj",
              "# (c) Somebody\n# other\n" + test::objOf({110.0F, -50.0F, -100.0F, 1500.0F}));
        QCOMPARE(load()->set.anatomy.attributions, std::vector<std::string>{"(c) Somebody"});
    }

    void refusesAFolderWithoutAPatient()
    {
        QVERIFY(loadAnatomySet(m_set / "none", m_cache).error().code == Errc::FileNotFound);
        std::filesystem::remove_all(m_set);
        std::filesystem::create_directories(m_set);
        QVERIFY(load().error().code == Errc::NothingRecognised);
        write("Teapot.obj", test::objOf({110.0F}));
        QVERIFY(load().error().code == Errc::NothingRecognised);
        write("Trachea.obj", "");
        const auto loaded = load();
        QVERIFY(loaded.error().code == Errc::NothingRecognised);
        QVERIFY(loaded.error().detail.find("Trachea.obj: it is empty") != std::string::npos);
        write("Trachea.obj", test::objOf({1e6F}));
        QVERIFY(load().error().code == Errc::OutOfRange);
    }

    void stopsWhenItIsToldTo()
    {
        const auto loaded = loadAnatomySet(m_set, m_cache, [](double) { return false; });
        QVERIFY(loaded.error().code == Errc::Cancelled);
        QVERIFY(!std::filesystem::exists(m_cache));
        double last = 0.0;
        const auto grows = [&](double share) { return std::exchange(last, share) <= share; };
        const auto whole = loadAnatomySet(m_set, m_cache, grows);
        QVERIFY(last >= 0.6 && last <= 1.0);
        QVERIFY(whole.has_value());
    }

    void givesTheSameForTheSameFiles()
    {
        const auto first = load(CacheUse::Renewed);
        const auto second = load(CacheUse::Renewed);
        QVERIFY(!first->fromCache && !second->fromCache);
        QVERIFY(encodeSet(first->set) == encodeSet(second->set));
        const auto third = load();
        QVERIFY(third->fromCache);
        QVERIFY(encodeSet(first->set) == encodeSet(third->set));
    }

    void namesContentByWhatItIs()
    {
        const std::string hash = load()->set.anatomy.contentHash;
        const auto elsewhere = m_set.parent_path() / "Copy";
        std::filesystem::copy(m_set, elsewhere, std::filesystem::copy_options::recursive);
        const auto copy = loadAnatomySet(elsewhere, m_cache);
        QVERIFY(copy->fromCache);
        QCOMPARE(copy->set.anatomy.contentHash, hash);
        QCOMPARE(copy->set.anatomy.name, std::string{"Copy"});
        std::filesystem::rename(m_set / "Mandible.obj", m_set / "Mandible 2.obj");
        QVERIFY(load()->set.anatomy.contentHash != hash);
        write("Mandible.obj", test::objOf({111.0F, -50.0F, -100.0F, 1500.0F}));
        std::filesystem::remove(m_set / "Mandible 2.obj");
        const auto changed = load();
        QVERIFY(!changed->fromCache);
        QVERIFY(changed->set.anatomy.contentHash != hash);
    }

    void importsAnewWhatTheCacheHoldsDamaged()
    {
        const auto file = load()->cacheFile;
        QVERIFY(std::filesystem::exists(file));
        QVERIFY(std::filesystem::exists(std::filesystem::path{file}.replace_extension(".json")));
        const auto size = std::filesystem::file_size(file);
        std::filesystem::resize_file(file, size - 1);
        QVERIFY(!load()->fromCache);
        QCOMPARE(std::filesystem::file_size(file), size);
        QVERIFY(load()->fromCache);
        for (const auto& entry : std::filesystem::directory_iterator{m_cache})
            if (entry.path().extension() == ".listing")
                test::writeFile(entry.path(), "../../etc/passwd");
        QVERIFY(load()->fromCache);
    }

    void writesNothingIntoTheSource()
    {
        const auto before = contentsOf(m_set);
        QVERIFY(!load()->fromCache);
        QVERIFY(load()->fromCache);
        QVERIFY(contentsOf(m_set) == before);
    }

    void importsAlthoughTheCacheCannotBeWritten()
    {
        test::writeFile(m_cache, "a file where a folder should be");
        const auto loaded = load();
        QVERIFY(loaded.has_value());
        QVERIFY(loaded->cacheFault.has_value());
        QVERIFY(loaded->cacheFault->code == Errc::FileUnwritable);
    }
};

CARINA_TEST(TestAnatomySet)

} // namespace carina::anatomy_set_test

#include "tst_anatomy_set.moc"
