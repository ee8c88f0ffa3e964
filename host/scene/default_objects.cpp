#include "host/scene/default_objects.hpp"

namespace pxm::host {

std::vector<ObjectBlock> objects_of(const Scene& scene) {
    if (!scene.objects.empty()) return scene.objects;
    std::vector<ObjectBlock> objects;
    for (const IfsBlock& ifs : scene.ifs) {
        ObjectBlock object;
        object.name = ifs.name;
        object.ifs = ifs.name;
        object.ifs_position = object.position = ifs.position;
        objects.push_back(object);
    }
    return objects;
}

}  // namespace pxm::host
