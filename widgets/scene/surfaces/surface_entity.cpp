#include "widgets/scene/surfaces/surface_entity.h"

#include "widgets/scene/look/chest_uniforms.h"

#include <Qt3DCore/QEntity>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>

#include <algorithm>
#include <utility>

namespace carina
{

namespace
{

std::vector<Qt3DRender::QParameter*> motionParameters(bool hasManyRegions)
{
    if (!hasManyRegions)
        return {new Qt3DRender::QParameter(QStringLiteral("motion"), QMatrix4x4{})};
    std::vector<Qt3DRender::QParameter*> parameters;
    for (std::size_t region = 0; region < kChestRegions; ++region)
        parameters.push_back(new Qt3DRender::QParameter(
            QStringLiteral("regions[%1].motion").arg(region), QMatrix4x4{}));
    return parameters;
}

std::vector<Qt3DRender::QParameter*> parametersOf(std::span<const NamedUniform> uniforms)
{
    std::vector<Qt3DRender::QParameter*> parameters;
    for (const NamedUniform& uniform : uniforms)
        parameters.push_back(
            new Qt3DRender::QParameter(QString::fromLatin1(uniform.name), uniform.value));
    return parameters;
}

} // namespace

SurfaceEntity::SurfaceEntity(MergedSurface surface, Qt3DRender::QEffect* effect,
                             Qt3DCore::QEntity* parent)
    : m_key(std::move(surface.key)),
      m_pieces(std::move(surface.pieces)),
      m_triangles(std::move(surface.triangles)),
      m_entity(std::make_unique<Qt3DCore::QEntity>(parent)),
      m_material(new Qt3DRender::QMaterial(m_entity.get())),
      m_columns(surfaceColumns(surface.vertices, m_entity.get())),
      m_bent(m_columns.vertices),
      m_chest(new Qt3DRender::QParameter(QStringLiteral("chest"), QMatrix4x4{})),
      m_motions(motionParameters(!m_key.region)),
      m_airway(parametersOf(airwayUniforms({}))),
      m_neck(parametersOf(neckUniforms({}))),
      m_throat(new Qt3DRender::QParameter(QStringLiteral("throat"), throatUniform({}))),
      m_jaw(new Qt3DRender::QParameter(QStringLiteral("jaw"), jawUniform({}))),
      m_blade(new Qt3DRender::QParameter(QStringLiteral("blade"), bladeUniform({}))),
      m_tilt(new Qt3DRender::QParameter(QStringLiteral("tilt"), tiltUniform({})))
{
    if (m_key.layer == DrawLayer::Blended)
        for (const SurfaceVertex& vertex : surface.vertices)
            m_positions.push_back(vertex.position);
    setMotion({});
    m_material->setEffect(effect);
    m_material->addParameter(m_chest);
    for (Qt3DRender::QParameter* motion : m_motions)
        m_material->addParameter(motion);
    for (const auto* parameters : {&m_airway, &m_neck})
        for (Qt3DRender::QParameter* parameter : *parameters)
            m_material->addParameter(parameter);
    for (Qt3DRender::QParameter* parameter : {m_throat, m_jaw, m_blade, m_tilt})
        m_material->addParameter(parameter);
    m_shares.push_back(
        std::make_unique<SurfaceShare>(std::string{}, m_columns, m_material, m_entity.get()));
}

SurfaceEntity::~SurfaceEntity() = default;

void SurfaceEntity::setMotion(const BreathingChest& chest)
{
    if (m_key.region) {
        m_motions.front()->setValue(motionUniform(chest.of(*m_key.region)));
        return;
    }
    for (std::size_t region = 0; region < kChestRegions; ++region)
        m_motions[region]->setValue(motionUniform(chest.motion[region]));
}

/// Not for each frame anew where there is nothing to change.
void SurfaceEntity::setAirway(const AirwayField& airway)
{
    if (!airway.isThere() && !m_isAirwayChanged)
        return;
    m_isAirwayChanged = airway.isThere();
    const auto uniforms = airwayUniforms(airway);
    for (std::size_t i = 0; i < uniforms.size(); ++i)
        m_airway[i]->setValue(uniforms[i].value);
}

/// Likewise.
void SurfaceEntity::setNeck(const SceneFrame& frame)
{
    const auto inPlace = frame.bentInPlace.find(m_key.body);
    const bool isInPlace = inPlace != frame.bentInPlace.end();
    const NeckField neck = isInPlace || m_key.body == frame.bends ? frame.throat.neck : NeckField{};
    if (!neck.isBent() && !m_isNeckBent)
        return;
    m_isNeckBent = neck.isBent();
    const auto uniforms =
        neckUniforms(neck, isInPlace ? std::optional{inPlace->second} : std::nullopt);
    for (std::size_t i = 0; i < uniforms.size(); ++i)
        m_neck[i]->setValue(uniforms[i].value);
}

/// Those that are blended are sorted as they lie at rest.
void SurfaceEntity::setLine(const SceneFrame& frame)
{
    const auto along = frame.bentAlong.find(m_key.body);
    m_bent.follow(along == frame.bentAlong.end() ? nullptr : along->second.get());
}

/// Gives each group that is lifted out, and of which parts are here, a share of its own.
void SurfaceEntity::liftShares(const SceneFrame& frame)
{
    const auto isOf = [](const auto& entry) {
        return [&entry](const auto& share) { return share->liftedWith() == entry.first; };
    };
    const auto isHere = [](const auto& entry) {
        return [&entry](const SurfacePiece& piece) { return piece.liftedWith == entry.first; };
    };
    for (const auto& entry : frame.lifted)
        if (std::ranges::none_of(m_shares, isOf(entry))
            && std::ranges::any_of(m_pieces, isHere(entry)))
            m_shares.push_back(
                std::make_unique<SurfaceShare>(entry.first, m_columns, m_material, m_entity.get()));
}

void SurfaceEntity::apply(const SceneFrame& frame)
{
    liftShares(frame);
    for (const auto& share : m_shares) {
        const bool isInUse =
            share->liftedWith().empty() || frame.lifted.contains(share->liftedWith());
        if (isInUse != share->isInUse())
            m_levels.clear(); // all of it is chosen anew
        share->setInUse(isInUse);
        share->place(placeOf(frame, m_key.body, share->liftedWith()));
    }
    m_chest->setValue(chestUniform(frame.chest.field));
    setMotion(frame.chest);
    setAirway(frame.airway);
    setNeck(frame);
    setLine(frame);
    m_throat->setValue(throatUniform(frame.throat.field));
    // What has the mandible for its body has moved with the jaw, and no blade pushes it.
    const bool follows = m_key.body == frame.bends;
    m_jaw->setValue(jawUniform(follows ? frame.throat.X_AJ : RigidTransform{}));
    const BladeField blade = follows ? frame.blade : BladeField{};
    m_blade->setValue(bladeUniform(blade));
    m_tilt->setValue(tiltUniform(blade));
}

/// The pieces that a share draws; what is not lifted out is drawn in its place.
std::vector<SurfacePiece> SurfaceEntity::piecesOf(const SurfaceShare& share) const
{
    const auto drawnBy = [this](const SurfacePiece& piece) {
        const auto lifted = std::ranges::find_if(m_shares, [&piece](const auto& other) {
            return other->isInUse() && other->liftedWith() == piece.liftedWith;
        });
        return lifted == m_shares.end() ? m_shares.front().get() : lifted->get();
    };
    std::vector<SurfacePiece> pieces;
    std::ranges::copy_if(m_pieces, std::back_inserter(pieces),
                         [&](const SurfacePiece& piece) { return drawnBy(piece) == &share; });
    return pieces;
}

void SurfaceEntity::show(std::span<const int> levels, const Vec3& forward_A)
{
    const bool isBlended = m_key.layer == DrawLayer::Blended;
    const bool isNew = !std::ranges::equal(levels, m_levels);
    m_levels.assign(levels.begin(), levels.end());
    for (const auto& share : m_shares) {
        if (isNew) {
            std::vector<Triangle> chosen =
                trianglesAt(levels, piecesOf(*share), m_triangles, m_isCut);
            if (isBlended)
                share->drawSorted(std::move(chosen), m_positions, forward_A);
            else
                share->draw(chosen);
        } else if (isBlended) {
            share->sort(forward_A);
        }
        share->show();
    }
}

void SurfaceEntity::setCut(bool cut)
{
    if (cut != m_isCut)
        m_levels.clear(); // all of it is chosen anew
    m_isCut = cut;
}

} // namespace carina
