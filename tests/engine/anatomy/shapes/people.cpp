#include "tests/engine/anatomy/shapes/people.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_query.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/section.h"

#include <QTest>

#include <algorithm>
#include <map>

namespace carina::test
{
namespace
{

const std::map<std::string, PatientParameters>& whoIsWho()
{
    static const std::map<std::string, PatientParameters> people{
        {"man", {30.0, metres(1.75), Sex::Male, Habitus::Normal, {}}},
        {"woman", {30.0, metres(1.62), Sex::Female, Habitus::Normal, {}}},
        {"12 years", {12.0, metres(1.50), Sex::Male, Habitus::Normal, {}}},
        {"6 years", {6.0, metres(1.16), Sex::Male, Habitus::Normal, {}}}};
    return people;
}

bool meet(const Box& a, const Box& b)
{
    return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

bool seemsWithin(const SurfaceTree& tree, const Vec3& p)
{
    const auto nearest = tree.nearestTo(p);
    return nearest && nearest->normal.dot(p - nearest->p) < 0.0;
}

} // namespace

const Anatomy& personCalled(const std::string& name)
{
    static std::map<std::string, Anatomy> made;
    const auto found = made.find(name);
    if (found != made.end())
        return found->second;
    return made.emplace(name, patientFor(whoIsWho().at(name)).value()).first->second;
}

void people()
{
    QTest::addColumn<QString>("name");
    for (const auto& [name, who] : whoIsWho())
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

const TriangleMesh& named(const Anatomy& anatomy, const std::string& part)
{
    const auto found = std::ranges::find(anatomy.parts, part, &AnatomyPart::name);
    Q_ASSERT(found != anatomy.parts.end());
    return found->levels.front();
}

int verticesWithin(const TriangleMesh& surface, const TriangleMesh& other)
{
    const Box box = boundsOf(other);
    if (!meet(box, boundsOf(surface)))
        return 0;
    const SurfaceTree tree{other};
    return int(std::ranges::count_if(surface.positions, [&](const Vec3f& p) {
        const Vec3 p_A = p.cast<double>();
        return distanceTo(box, p_A) == 0.0 && seemsWithin(tree, p_A)
               && windingNumber(other, p_A) > 0.5;
    }));
}

int verticesOutside(const TriangleMesh& surface, const TriangleMesh& other)
{
    const SurfaceTree tree{other};
    return int(std::ranges::count_if(surface.positions, [&](const Vec3f& p) {
        const Vec3 p_A = p.cast<double>();
        return !seemsWithin(tree, p_A) && windingNumber(other, p_A) < 0.5;
    }));
}

} // namespace carina::test
