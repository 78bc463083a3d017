#include "widgets/scene/look/organ_shader.h"

#include "resources/resources.h"

namespace carina
{

QByteArray organVertexShader(const OrganShader& needs)
{
    QByteArray defined;
    if (needs.hasManyRegions)
        defined += "#define MANY_REGIONS\n";
    if (needs.movesJaw)
        defined += "#define JAW_MOVES\n";
    if (needs.pushesTissue)
        defined += "#define BLADE_PUSHES\n";
    if (needs.changesAirway)
        defined += "#define AIRWAY_CHANGES\n";
    if (needs.bendsNeck)
        defined += "#define NECK_BENDS\n";
    if (needs.isSpotlit)
        defined += "#define SPOTLIGHT\n";
    if (needs.isMoist)
        defined += "#define MOIST\n";
    QByteArray source = resource("shaders/organ.vert");
    return source.insert(source.indexOf('\n') + 1, defined); // #version stays first
}

} // namespace carina
